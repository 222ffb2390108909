// What of the world is seen: the view of the film, or one that the reader has chosen.

const kLeastScale = 1 / 4096; // of the largest; farther away everything is a dot
const kTouch = 0.02;          // bodies this near touch: slops and skins of the engine [m]

class View {
  constructor(film) {
    this.film = film;
    this.own = null;      // {x, y, height: of the picture [m]}; null: that of the film
    this.followed = -1;   // number of a body, or -1
    this.lastPlace = null; // where it was when it was last drawn [m]
    this.width = film.width; // of the canvas [its px]
    this.height = film.height;
  }
  resize(width, height) {
    this.width = width;
    this.height = height;
  }
  // {x, y: of the middle [m], scale [px/m]}
  of(frame) {
    const filmed = this.film.viewOf(frame);
    if (this.own) return {x: this.own.x, y: this.own.y, scale: this.height / this.own.height};
    const fit = Math.min(this.width / this.film.width, this.height / this.film.height);
    return {x: filmed.x, y: filmed.y, scale: filmed.scale * fit};
  }
  limited(scale) {
    const full = this.film.fullScale;
    return Math.min(Math.max(scale, full * kLeastScale), full);
  }
  toWorld(view, x, y) {
    return [view.x + (x - 0.5 * this.width) / view.scale, view.y - (y - 0.5 * this.height) / view.scale];
  }
  choose(view) {
    this.own = {x: view.x, y: view.y, height: this.height / view.scale};
  }
  // About a point of the canvas [px], which keeps its place.
  zoom(frame, factor, x, y) {
    const view = this.of(frame);
    const [worldX, worldY] = this.toWorld(view, x, y);
    const scale = this.limited(view.scale * factor);
    this.choose({
      x: worldX - (x - 0.5 * this.width) / scale,
      y: worldY + (y - 0.5 * this.height) / scale,
      scale,
    });
  }
  pan(frame, dx, dy) {
    const view = this.of(frame);
    this.choose({x: view.x - dx / view.scale, y: view.y + dy / view.scale, scale: view.scale});
  }
  reset() {
    this.own = null;
    this.follow(-1);
  }
  follow(body) {
    this.followed = body;
    this.lastPlace = null;
  }
  // Moves with the body that is followed, not with the film. Call it once for each frame that is shown.
  track(frame) {
    if (this.followed < 0) return;
    const body = describeBody(this.film, frame, this.followed);
    if (!body) return;
    const view = this.of(frame), [x, y] = this.lastPlace ?? [body.x, body.y];
    this.choose({x: view.x + body.x - x, y: view.y + body.y - y, scale: view.scale});
    this.lastPlace = [body.x, body.y];
  }
}

// Calls `visit(track, at)` for each track; `at`: of its numbers.
function eachTrack(frame, visit) {
  let at = 0;
  for (const track of frame.tracks) {
    visit(track, at);
    at += track.form.numbers;
  }
}

// The place of a body, and its velocity if the page has it; null without either. `before`: the frame
// before, or null.
function describeBody(film, frame, number, before = null) {
  let state = null, shape = null;
  eachTrack(frame, (track, at) => {
    if (track.owner !== number) return;
    if (track.form.isBody) state = {track, at};
    else if (!shape && film.styles[track.style] === kShapes) shape = {track, at};
  });
  const placed = state?.track.form.hasPlace ? state : shape;
  if (!placed) return null;
  const found = {number, name: film.names[number] ?? "", hasAngle: !!state || placed.track.form.isRigid,
                 ...placeOf(film, placed.track, frame.numbers, placed.at)};
  if (!state) return found;
  // Stored is the velocity less what the change of place since the frame before says.
  const rate = film.framesPerSecond / film.speed;
  const earlier = before?.tracks.includes(state.track) ? describeBody(film, before, number) : found;
  const at = state.at + state.track.form.numbers - 3;
  [found.vx, found.vy, found.spin] = ["x", "y", "angle"].map((key, k) =>
    frame.numbers[at + k] * kVelocityUnit + (found[key] - earlier[key]) * rate);
  return found;
}

function placeOf(film, {form}, numbers, at) {
  const x = numbers[at] * film.quantum, y = numbers[at + 1] * film.quantum;
  if (form.isBody) return {x, y, angle: numbers[at + 2] * kAngleUnit};
  if (!form.isRigid) return {x, y, angle: 0};
  const angle = numbers[at + 2] * form.angleUnit;
  const [localX, localY] = form.origin;
  const c = Math.cos(angle), s = Math.sin(angle);
  return {x: x + c * localX - s * localY, y: y + s * localX + c * localY, angle};
}

// Calls `visit(item, points, owner)` for each item of a body's shapes; `points` [m] are overwritten
// afterwards.
function eachShape(film, frame, visit) {
  let world = new Float64Array(64);
  eachTrack(frame, (track, at) => {
    if (track.owner < 0 || film.styles[track.style] !== kShapes) return;
    if (world.length < 2 * track.form.pointCount) world = new Float64Array(4 * track.form.pointCount);
    placePoints(track.form, frame.numbers, at, film.quantum, world);
    let first = 0;
    for (const item of track.form.items) {
      visit(item, world.subarray(first, first + 2 * item.count), track.owner);
      first += 2 * item.count;
    }
  });
}

// The numbers of all bodies in a frame.
function bodiesOf(film, frame) {
  const found = new Set();
  eachTrack(frame, track => {
    if (track.owner >= 0 && (track.form.isBody || film.styles[track.style] === kShapes)) found.add(track.owner);
  });
  return [...found].sort((a, b) => a - b);
}

// The number of the topmost body with a shape at the point [m] or within `reach` [m] of it, or -1.
function bodyAt(film, frame, x, y, reach, hidden) {
  let found = -1, nearest = reach;
  if (hidden.has(kShapes)) return found;
  eachShape(film, frame, (item, points, owner) => {
    const distance = distanceTo(item, points, x, y);
    if (distance <= nearest) {
      nearest = Math.max(distance, 0); // a shape above covers it
      found = owner;
    }
  });
  return found;
}

// The point of an item's outline next to a place: [x, y, distance], or null.
function outlineAt(item, points, x, y) {
  if (item.kind === kCircle || item.kind === kSolidCircle) {
    const dx = x - points[0], dy = y - points[1], length = Math.hypot(dx, dy), radius = Math.abs(item.size);
    const share = length > 0 ? radius / length : 0;
    return [points[0] + share * dx, points[1] + share * dy, Math.abs(length - radius)];
  }
  if (item.kind > kSegment) return null;
  let nearest = null;
  for (let i = 0, j = points.length - 2; i < points.length; j = i, i += 2) {
    const ax = points[j], ay = points[j + 1], dx = points[i] - ax, dy = points[i + 1] - ay;
    const share = Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1), 0), 1);
    const px = ax + share * dx, py = ay + share * dy, distance = Math.hypot(x - px, y - py);
    if (!nearest || distance < nearest[2]) nearest = [px, py, distance];
  }
  return nearest;
}

// To an item's edge [m]; 0 or less inside of a solid one.
function distanceTo(item, points, x, y) {
  const outline = outlineAt(item, points, x, y);
  if (!outline) return Infinity;
  if (item.kind === kSolidCircle) return Math.max(Math.hypot(x - points[0], y - points[1]) - Math.abs(item.size), 0);
  let isInside = false;
  for (let i = 0, j = points.length - 2; i < points.length; j = i, i += 2) {
    const ax = points[j], ay = points[j + 1], bx = points[i], by = points[i + 1];
    if (ay > y !== by > y && x < ax + (y - ay) / (by - ay) * (bx - ax)) isInside = !isInside;
  }
  return isInside && item.kind === kSolidPolygon ? 0 : outline[2];
}

// Where two bodies touch, next to a place [m] and within `reach` [m] of it, or null: a corner of one at
// the outline of the other, or the point of a circle next to it. Pages need not store contacts for it.
function touchAt(film, frame, x, y, reach) {
  const shapes = [];
  eachShape(film, frame, (item, points, owner) => {
    if (distanceTo(item, points, x, y) <= reach) shapes.push({item, points: points.slice(), owner});
  });
  let found = null, nearest = reach;
  const offer = (point, gap) => {
    const distance = Math.hypot(x - point[0], y - point[1]);
    if (gap > kTouch || distance > nearest) return;
    nearest = distance;
    found = [point[0], point[1]];
  };
  for (const a of shapes) {
    for (const b of shapes) {
      if (a.owner === b.owner) continue;
      const isRound = a.item.kind === kCircle || a.item.kind === kSolidCircle;
      for (let i = 0; i < (isRound ? 2 : a.points.length); i += 2) {
        const px = a.points[i], py = a.points[i + 1], outline = outlineAt(b.item, b.points, px, py);
        if (outline) offer(outline, isRound ? Math.abs(outline[2] - Math.abs(a.item.size)) : outline[2]);
      }
    }
  }
  return found;
}

// The contact point next to a place [m] and within `reach` [m], or null.
function contactAt(film, frame, x, y, reach) {
  let found = null, nearest = reach;
  eachTrack(frame, (track, at) => {
    if (film.styles[track.style] !== kContacts || track.form.items[0].kind !== kPoint) return;
    const contactX = frame.numbers[at] * film.quantum, contactY = frame.numbers[at + 1] * film.quantum;
    const distance = Math.hypot(x - contactX, y - contactY);
    if (distance <= nearest) {
      nearest = distance;
      found = [contactX, contactY];
    }
  });
  return found;
}
