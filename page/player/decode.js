// Reads the frames of a page. docs/notes/page-format.md describes the bytes, page/src/PageEncoder.cpp
// writes them. Needs no document.

const kShapes = 0, kContacts = 4, kNormals = 5, kImpulses = 6, kFriction = 7, kCenters = 8, kCenterMarks = 9,
  kVelocities = 10, kForces = 11, kGlyphs = 12, kLabels = 13, kAnnotations = 17; // DrawLayer
const kPolygon = 0, kSolidPolygon = 1, kCircle = 2, kSolidCircle = 3, kSegment = 4, kTransform = 5,
  kPoint = 6, kText = 7; // DrawKind
const kFormSteps = 16, kViewSteps = 16; // points of forms and views are this much finer than places
const kVelocityUnit = 0.02; // [m/s, rad/s]
const kAngleUnit = 0.0001;  // of a body with a place of its own [rad]
const kFirstLarge = 0xf8;

class Bytes {
  constructor(array) {
    this.array = array;
    this.at = 0;
  }
  varint() {
    let number = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = this.array[this.at++];
      number += (byte & 127) * scale;
      if (byte < 128) return number;
    }
  }
  signed() {
    return fromZigzag(this.varint());
  }
  float() {
    const view = new DataView(this.array.buffer, this.array.byteOffset + this.at, 4);
    this.at += 4;
    return view.getFloat32(0, true);
  }
  part() {
    const length = this.varint();
    this.at += length;
    return this.array.subarray(this.at - length, this.at);
  }
}

// 0, 1, 2, 3, … become 0, -1, 1, -2, …
function fromZigzag(number) {
  return number % 2 === 0 ? number / 2 : -(number + 1) / 2;
}

// Differences of predictions: small ones in a byte, others in as many as it says.
class Column {
  constructor(bytes) {
    this.small = bytes.part();
    this.large = bytes.part();
    this.atSmall = 0;
    this.atLarge = 0;
    this.last = 0;
  }
  difference() {
    const small = this.small[this.atSmall++];
    if (small < kFirstLarge) return fromZigzag(small);
    let number = 0;
    for (let scale = 1, left = small - kFirstLarge + 1; left > 0; --left, scale *= 256) {
      number += this.large[this.atLarge++] * scale;
    }
    return fromZigzag(number);
  }
  next(predictor) {
    const guess = predictor.count === 0 ? this.last : predictor.guess();
    this.last = guess + this.difference();
    predictor.add(this.last);
    return this.last;
  }
}

// The rules that a number stays, goes on at its speed, or at its acceleration; the one that was best
// lately guesses.
class Predictor {
  constructor() {
    this.count = 0;
    this.a = this.b = this.c = 0;
    this.stayError = this.speedError = this.bendError = 0;
  }
  guess() {
    const {a, b, c, count} = this;
    if (count === 1 || (this.stayError <= this.speedError && (count === 2 || this.stayError <= this.bendError))) return a;
    return count === 2 || this.speedError <= this.bendError ? 2 * a - b : 3 * (a - b) + c;
  }
  add(number) {
    const {a, b, c, count} = this;
    if (count > 0) this.stayError += Math.abs(number - a) - Math.floor(this.stayError / 4);
    if (count > 1) this.speedError += Math.abs(number - (2 * a - b)) - Math.floor(this.speedError / 4);
    if (count > 2) this.bendError += Math.abs(number - (3 * (a - b) + c)) - Math.floor(this.bendError / 4);
    this.c = b;
    this.b = a;
    this.a = number;
    this.count = Math.min(count + 1, 3);
  }
}

// What items are, without their place.
function readForm(bytes, quantum) {
  // 0: each point moves on its own; 1: all as one; 2: with a body's origin; 3: the velocity of a body;
  // 4: its place and velocity
  const type = bytes.varint();
  const form = {isRigid: type === 1 || type === 2, hasOrigin: type === 2, isBody: type > 2, hasPlace: type === 4,
                items: [], pointCount: 0, points: null, origin: [0, 0], angleUnit: 1, numbers: 0};
  for (let left = bytes.varint(); left > 0; --left) {
    const item = {kind: bytes.varint(), count: bytes.varint(), size: bytes.float(), text: -1};
    if (item.kind === kText) item.text = bytes.varint();
    form.items.push(item);
    form.pointCount += item.count;
  }
  form.numbers = form.isBody ? (form.hasPlace ? 6 : 3) : form.isRigid ? 3 : 2 * form.pointCount;
  if (!form.isRigid) return form;
  const unit = quantum / kFormSteps;
  form.points = new Float64Array(2 * form.pointCount);
  let farthest = 0;
  for (let i = 0; i < form.points.length; i += 2) {
    const x = form.points[i] = bytes.signed() * unit;
    const y = form.points[i + 1] = bytes.signed() * unit;
    farthest = Math.max(farthest, x * x + y * y);
  }
  if (form.hasOrigin) form.origin = [bytes.signed() * unit, bytes.signed() * unit];
  if (farthest > 0) form.angleUnit = quantum / Math.sqrt(farthest);
  return form;
}

function readForms(array, quantum) {
  const bytes = new Bytes(array);
  const forms = [];
  while (bytes.at < array.length) forms.push(readForm(bytes, quantum));
  return forms;
}

// Frames that are packed together. They are read in their order, as far as asked for.
class FrameGroup {
  constructor(array, forms) {
    const bytes = new Bytes(array);
    this.forms = forms;
    this.count = bytes.varint();
    this.sequence = new Bytes(bytes.part());
    this.rigid = [new Column(bytes), new Column(bytes), new Column(bytes)];
    this.loose = [new Column(bytes), new Column(bytes)];
    this.view = new Column(bytes);
    this.velocity = [new Column(bytes), new Column(bytes), new Column(bytes)];
    this.viewPredictors = [new Predictor(), new Predictor(), new Predictor()];
    this.tracks = [];
    this.predictors = [];
    this.frames = [];
  }
  // {tracks: [{form, style, owner}], numbers: of all tracks, one after the other, view: [x, y, height]}
  frame(index) {
    while (this.frames.length <= index) this.frames.push(this.readFrame());
    return this.frames[index];
  }
  readFrame() {
    this.readSequence();
    this.readStyles();
    const view = this.viewPredictors.map(predictor => this.view.next(predictor));
    let count = 0;
    for (const track of this.tracks) count += track.form.numbers;
    const numbers = new Float64Array(count);
    let at = 0;
    for (let t = 0; t < this.tracks.length; ++t) {
      const form = this.tracks[t].form;
      const predictors = this.predictors[t];
      const columns = form.isRigid || form.isBody ? this.rigid : this.loose;
      const places = form.isBody ? form.numbers - 3 : form.numbers;
      for (let k = 0; k < places; ++k) {
        numbers[at++] = columns[k % columns.length].next(predictors[k]);
      }
      for (let k = 0; k < form.numbers - places; ++k) numbers[at++] = this.velocity[k].difference();
    }
    return {tracks: this.tracks, numbers, view};
  }
  // By turns: how many tracks are kept, end and begin. All that follow are kept.
  readSequence() {
    let turns = this.sequence.varint();
    if (turns === 0) return;
    const tracks = [], predictors = [];
    let old = 0;
    const keep = end => {
      for (; old < end; ++old) {
        tracks.push(this.tracks[old]);
        predictors.push(this.predictors[old]);
      }
    };
    for (; turns > 0; --turns) {
      keep(old + this.sequence.varint());
      old += this.sequence.varint();
      for (let begun = this.sequence.varint(); begun > 0; --begun) {
        const form = this.forms[this.sequence.varint()];
        tracks.push({form, style: this.sequence.varint(), owner: this.sequence.varint() - 1});
        predictors.push(Array.from({length: form.numbers}, () => new Predictor()));
      }
    }
    keep(this.tracks.length);
    this.tracks = tracks;
    this.predictors = predictors;
  }
  readStyles() {
    let changes = this.sequence.varint();
    if (changes === 0) return;
    this.tracks = this.tracks.slice();
    for (let at = 0; changes > 0; --changes) {
      at += this.sequence.varint();
      this.tracks[at] = {...this.tracks[at], style: this.sequence.varint()};
    }
  }
}

// Where the points of a track are [m]: x and y by turns, into `points`. `at`: of its numbers.
function placePoints(form, numbers, at, quantum, points) {
  const count = 2 * form.pointCount;
  if (!form.isRigid) {
    for (let i = 0; i < count; ++i) points[i] = numbers[at + i] * quantum;
    return;
  }
  const x = numbers[at] * quantum, y = numbers[at + 1] * quantum, angle = numbers[at + 2] * form.angleUnit;
  const c = Math.cos(angle), s = Math.sin(angle);
  const local = form.points;
  for (let i = 0; i < count; i += 2) {
    points[i] = x + c * local[i] - s * local[i + 1];
    points[i + 1] = y + s * local[i] + c * local[i + 1];
  }
}

async function unpack(base64) {
  const text = atob(base64);
  const packed = Uint8Array.from(text, letter => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// All frames of a page. Groups are unpacked when they are needed, and a few are kept.
class Film {
  static async open(head, packedGroups) {
    const film = new Film();
    Object.assign(film, head);
    film.damaged = () => {}; // called with a group that cannot be read, and the error
    film.forms = readForms(await unpack(head.forms), head.quantum);
    film.groups = [];
    let first = 0;
    for (const {frames, base64} of packedGroups) {
      film.groups.push({first, frames, base64, content: null, loading: null});
      first += frames;
    }
    return film;
  }
  groupAt(frame) {
    return this.groups.find(group => frame < group.first + group.frames);
  }
  async load(group) {
    group.loading ??= unpack(group.base64()).then(array => {
      group.content = new FrameGroup(array, this.forms);
      group.loading = null;
      this.dropOthers(group);
      return group;
    }, error => {
      this.damaged(group, error);
      throw error;
    });
    return group.loading;
  }
  // Memory does not grow with the length of the film.
  dropOthers(latest) {
    const kKept = 5;
    const at = this.groups.indexOf(latest);
    this.groups.forEach((group, index) => {
      if (Math.abs(index - at) > kKept / 2) group.content = null;
    });
  }
  // The frame, or null while it is being unpacked; `done` is called then.
  frame(number, done) {
    const group = this.groupAt(number);
    const next = this.groups[this.groups.indexOf(group) + 1];
    if (next && !next.content && number > group.first + group.frames / 2) this.load(next).catch(() => {});
    if (group.content) return group.content.frame(number - group.first);
    this.load(group).then(done, () => {});
    return null;
  }
  async frameLater(number) {
    const group = this.groupAt(number);
    if (!group.content) await this.load(group);
    return group.content.frame(number - group.first);
  }
  secondsOf(frame) {
    return this.firstTime + frame * this.speed / this.framesPerSecond;
  }
  frameAt(seconds) {
    const frame = Math.round((seconds - this.firstTime) * this.framesPerSecond / this.speed);
    return Math.min(Math.max(frame, 0), this.frames - 1);
  }
  viewOf(frame) {
    const unit = this.quantum / kViewSteps;
    const [x, y, height] = frame.view.map(number => number * unit);
    return {x, y, scale: this.height / height}; // [m], [m], [px/m]
  }
}
