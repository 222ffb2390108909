// What of the world is seen: the view of the film, or one that the reader has chosen.

const kLeastScale = 1 / 4096; // of the largest; farther away everything is a dot

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
  // Moves with the body that is followed. Call it once for each frame that is shown.
  track(frame) {
    if (this.followed < 0) return;
    const body = describeBody(this.film, frame, this.followed);
    if (!body) return;
    if (this.lastPlace) {
      const view = this.of(frame);
      this.choose({x: view.x + body.x - this.lastPlace[0], y: view.y + body.y - this.lastPlace[1], scale: view.scale});
    }
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

// The origin and the angle of a body, or the centre of its first shape where the page has no more; null
// if it has no shape. Its velocity needs the frame before.
function describeBody(film, frame, number, before = null) {
  let found = null;
  eachTrack(frame, (track, at) => {
    if (found || track.owner !== number || film.styles[track.style] !== kShapes) return;
    const place = placeOf(film, track, frame.numbers, at);
    found = {number, name: film.names[number] ?? "", style: track.style, form: track.form, ...place};
  });
  if (!found || !before) return found;
  const earlier = describeBody(film, before, number);
  if (earlier && earlier.form === found.form) {
    const rate = film.framesPerSecond / film.speed;
    found.vx = (found.x - earlier.x) * rate;
    found.vy = (found.y - earlier.y) * rate;
    found.spin = (found.angle - earlier.angle) * rate;
  }
  return found;
}

function placeOf(film, track, numbers, at) {
  const {form} = track;
  if (!form.isRigid) return {x: numbers[at] * film.quantum, y: numbers[at + 1] * film.quantum, angle: 0};
  const angle = numbers[at + 2] * form.angleUnit;
  const [x, y] = form.origin;
  const c = Math.cos(angle), s = Math.sin(angle);
  return {x: numbers[at] * film.quantum + c * x - s * y, y: numbers[at + 1] * film.quantum + s * x + c * y, angle};
}

// The number of the topmost body with a shape at the point [m] or within `reach` [m] of it, or -1.
function bodyAt(film, frame, x, y, reach, hidden) {
  let found = -1, nearest = reach;
  let world = new Float64Array(64);
  eachTrack(frame, (track, at) => {
    if (track.owner < 0 || film.styles[track.style] !== kShapes || hidden.has(kShapes)) return;
    if (world.length < 2 * track.form.pointCount) world = new Float64Array(4 * track.form.pointCount);
    placePoints(track.form, frame.numbers, at, film.quantum, world);
    let first = 0;
    for (const item of track.form.items) {
      const distance = distanceTo(item, world.subarray(first, first + 2 * item.count), x, y);
      if (distance <= nearest) {
        nearest = Math.max(distance, 0); // a shape above covers it
        found = track.owner;
      }
      first += 2 * item.count;
    }
  });
  return found;
}


// To an item's edge [m]; 0 or less inside of a solid one.
function distanceTo(item, points, x, y) {
  if (item.kind === kCircle || item.kind === kSolidCircle) {
    const distance = Math.hypot(x - points[0], y - points[1]) - Math.abs(item.size);
    return item.kind === kCircle ? Math.abs(distance) : Math.max(distance, 0);
  }
  if (item.kind > kSegment) return Infinity;
  const count = points.length / 2;
  let nearest = Infinity, isInside = false;
  for (let i = 0, j = count - 1; i < count; j = i++) {
    const ax = points[2 * j], ay = points[2 * j + 1], bx = points[2 * i], by = points[2 * i + 1];
    const dx = bx - ax, dy = by - ay;
    const share = Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1), 0), 1);
    nearest = Math.min(nearest, Math.hypot(x - ax - share * dx, y - ay - share * dy));
    if (ay > y !== by > y && x < ax + (y - ay) / dy * dx) isInside = !isInside;
  }
  return isInside && item.kind === kSolidPolygon ? 0 : nearest;
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
