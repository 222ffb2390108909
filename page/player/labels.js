// Places the names of bodies and joints where films place them: at what they name, or beside what is in
// their way. The same steps, numbers and order as LabelSpots.cpp and LabelObstacles.cpp in debugdraw/src,
// which give the reasons. Lengths are in pixels from the middle of the picture, y up.

const kSign = 0, kShape = 1, kLabel = 2, kCenter = 3; // what is in the way
const kBoxForm = 0, kCircleForm = 1, kLinesForm = 2;
const kSmallestCell = 16, kMostCells = 256; // only for speed; the result does not depend on them
const kLetterHeight = 12, kEdge = 2, kCenterReach = 0.5, kRounding = 0.5, kApart = 3 + kRounding, kClear = 3;
const kSpill = 5, kCorner = 2, kSlender = 3, kNear = 3, kWithoutTie = 26;
const kBeyondEnds = 66, kDistances = [10.5, 17, 25, 36, 50, kBeyondEnds];
const kAroundBody = [[0, 1], [0, -1], [1, 1], [1, -1], [-1, 1], [-1, -1], [1, 0], [-1, 0]];
const kAroundSign = [[1, 1], [1, -1], [-1, 1], [-1, -1], [1, 0], [-1, 0], [0, 1], [0, -1]];
const kOffEdge = 1 / 64; // of a pixel, see WorldBodies.cpp

class LabelObstacles {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.cell = Math.max(kSmallestCell, Math.max(width, height) / kMostCells);
    this.columns = 1 + Math.trunc(width / this.cell);
    this.rows = 1 + Math.trunc(height / this.cell);
    this.cells = Array.from({length: this.columns * this.rows}, () => []);
  }
  isInPicture(x, y) {
    return Math.abs(x) <= 0.5 * this.width && Math.abs(y) <= 0.5 * this.height;
  }
  cellsOf({left, bottom, right, top}) {
    const cell = (at, size, count) => Math.min(Math.trunc(Math.min(Math.max(at + 0.5 * size, 0), size) / this.cell), count - 1);
    return [cell(left, this.width, this.columns), cell(bottom, this.height, this.rows),
            cell(right, this.width, this.columns), cell(top, this.height, this.rows)];
  }
  // thing: {role, form, owner, left, bottom, right, top, points: of lines}
  add(thing) {
    const {width, height} = this;
    if (!(thing.left <= 0.5 * width && thing.bottom <= 0.5 * height && thing.right >= -0.5 * width && thing.top >= -0.5 * height)) return;
    const [first, low, last, high] = this.cellsOf(thing);
    thing.column = first;
    thing.row = low;
    for (let row = low; row <= high; ++row) {
      for (let column = first; column <= last; ++column) this.cells[row * this.columns + column].push(thing);
    }
  }
  // Calls `visit` once for each thing that may overlap the box, until it returns true; whether one has.
  findNear(box, visit) {
    const [first, low, last, high] = this.cellsOf(box);
    for (let row = low; row <= high; ++row) {
      for (let column = first; column <= last; ++column) {
        for (const thing of this.cells[row * this.columns + column]) {
          if (column === Math.max(thing.column, first) && row === Math.max(thing.row, low) && touch(thing, box) && visit(thing)) return true;
        }
      }
    }
    return false;
  }
}

class LabelSpots {
  // `obstacles`: LabelObstacles with all that is in the way.
  constructor(obstacles) {
    this.obstacles = obstacles;
  }
  // wishes: {x, y, width, owner} of the place that a label names; owner: -1 for a joint. Returns for each
  // {x, y: of the label's middle, tie: the end of a line from the place to it, or null}, or null.
  settle(wishes) {
    const spots = wishes.map(() => null);
    for (const wish of wishes) {
      if (wish.owner >= 0) this.obstacles.add({role: kCenter, form: kBoxForm, owner: wish.owner, ...widened(boxAt(wish.x, wish.y), kCenterReach)});
    }
    const settle = boxFor => wishes.forEach((wish, i) => {
      const box = !spots[i] && this.obstacles.isInPicture(wish.x, wish.y) && boxFor(wish);
      if (box) spots[i] = this.take(box, wish);
    });
    const onPlace = wish => {
      const box = this.boxOnPlace(wish);
      return this.countIn(box, wish) === 0 ? box : null;
    };
    settle(wish => this.fitsIn(this.boxOnPlace(wish), wish.owner) ? onPlace(wish) : null);
    settle(onPlace);
    settle(wish => this.bestBox(wish));
    return spots;
  }
  take(box, wish) {
    this.obstacles.add({role: kLabel, form: kBoxForm, owner: wish.owner, ...box});
    const tie = this.tieTo(box, wish);
    if (tie) {
      const points = [wish.x, wish.y, ...tie];
      this.obstacles.add({role: kSign, form: kLinesForm, owner: wish.owner, points, ...boundsOf(points)});
    }
    return {...middleOf(box), tie};
  }
  isInPicture({left, bottom, right, top}) {
    return this.obstacles.isInPicture(left - kEdge, bottom - kEdge) && this.obstacles.isInPicture(right + kEdge, top + kEdge);
  }
  // The number of things in its way, or -1 where it must not be.
  countIn(box, wish) {
    if (!this.isInPicture(box)) return -1;
    const core = crosses(wish.x, wish.y, wish.x, wish.y, box) ? coreOf(box) : box;
    const apart = {left: box.left - kApart, bottom: box.bottom - kRounding, right: box.right + kApart, top: box.top + kRounding};
    const clear = widened(box, kClear);
    let signs = 0, shapes = 0;
    const isRefused = this.obstacles.findNear(clear, thing => {
      const isOwn = thing.owner === wish.owner && wish.owner >= 0;
      if (thing.role === kLabel) return meets(thing, apart);
      if (thing.role === kCenter) return !isOwn && meets(thing, box);
      if (thing.role === kSign) signs += meets(thing, clear);
      else if (isOwn) signs += strikes(thing, clear);
      else shapes += meets(thing, core) && !contains(thing, wish.x, wish.y);
      return false;
    });
    if (isRefused) return -1;
    return signs + (shapes > 0 && this.fitsIn(box, wish.owner) ? 0 : shapes);
  }
  isStruck(box, owner) {
    return this.obstacles.findNear(box, thing => thing.role === kShape && thing.owner === owner && strikes(thing, box));
  }
  misleads(x0, y0, x1, y1) {
    return this.obstacles.findNear(widened(boundsOf([x0, y0, x1, y1]), kNear), thing => {
      const around = widened(thing, kNear);
      return (thing.role === kLabel && crosses(x0, y0, x1, y1, thing)) ||
             (thing.role === kCenter && !crosses(x0, y0, x0, y0, around) && crosses(x0, y0, x1, y1, around));
    });
  }
  isOnOwner(x, y, owner) {
    return this.obstacles.findNear(boxAt(x, y), thing => thing.role === kShape && thing.owner === owner && contains(thing, x, y));
  }
  tieTo(box, wish) {
    const x = clamp(wish.x, box.left, box.right), y = clamp(wish.y, box.bottom, box.top);
    const middle = middleOf(box);
    const isPlain = wish.owner >= 0 ? (x === wish.x && y === wish.y) || this.isOnOwner(middle.x, middle.y, wish.owner)
                                    : (x - wish.x) ** 2 + (y - wish.y) ** 2 < kWithoutTie ** 2;
    return isPlain ? null : [x, y];
  }
  boxOnPlace({x, y, width}) {
    const inside = (place, size, room) => {
      const most = Math.max(0, 0.5 * (room - size) - kEdge);
      return clamp(place, -most, most);
    };
    return boxAround(inside(x, width, this.obstacles.width), inside(y, kLetterHeight, this.obstacles.height), width);
  }
  bestBox(wish) {
    const isOfBody = wish.owner >= 0, mayFit = this.mayFitIn(wish);
    let best = null, fewest = -1, fits = false;
    const consider = box => {
      const count = this.countIn(box, wish);
      if (count < 0 || (fewest >= 0 && (count > fewest || (count === fewest && (fits || !mayFit))))) return;
      const fitsToo = mayFit && this.fitsIn(box, wish.owner);
      if (fewest === count && !fitsToo) return;
      const tie = this.tieTo(box, wish);
      if (tie && this.misleads(wish.x, wish.y, ...tie)) return;
      fewest = count;
      best = box;
      fits = fitsToo;
    };
    const onPlace = this.boxOnPlace(wish);
    consider(onPlace);
    const isStruck = isOfBody && this.isStruck(onPlace, wish.owner);
    let nearer = 0;
    for (const distance of kDistances) {
      if (distance === kBeyondEnds && !isStruck) break;
      for (const [right, up] of isOfBody ? kAroundBody : kAroundSign) {
        if (fewest === 0 && (fits || !mayFit)) return best;
        const isCorner = right !== 0 && up !== 0, straight = isOfBody ? distance : nearer;
        if (!isCorner && straight === 0) continue;
        const away = isCorner ? 0.7 * distance : straight;
        consider(boxAround(wish.x + right * (away + 0.5 * wish.width), wish.y + up * (away + 0.5 * kLetterHeight), wish.width));
      }
      nearer = distance;
    }
    return best;
  }
  fitsIn(box, owner) {
    const {left, bottom, right, top} = widened(box, -kCorner);
    return owner >= 0 && this.isOnOwner(left, bottom, owner) && this.isOnOwner(right, top, owner) &&
           this.isOnOwner(left, top, owner) && this.isOnOwner(right, bottom, owner);
  }
  mayFitIn({x, y, width, owner}) {
    return this.obstacles.findNear(boxAt(x, y), thing => owner >= 0 && thing.role === kShape && thing.owner === owner &&
      thing.right - thing.left >= width - 2 * kCorner && thing.top - thing.bottom >= kLetterHeight - 2 * kCorner);
  }
}

// Where a label begins that is less than that from the middle between two pixels, it begins at the second.
function offEdge(pixel) {
  const fraction = pixel + 0.5 - Math.floor(pixel + 0.5);
  return fraction < kOffEdge || fraction > 1 - kOffEdge ? Math.round(pixel + 0.5) - 0.5 + kOffEdge : pixel;
}

function boxAt(x, y) {
  return {left: x, bottom: y, right: x, top: y};
}
function boxAround(x, y, width) {
  return {left: x - 0.5 * width, bottom: y - 0.5 * kLetterHeight, right: x + 0.5 * width, top: y + 0.5 * kLetterHeight};
}
function boundsOf(points) {
  const bounds = boxAt(points[0], points[1]);
  for (let i = 2; i < points.length; i += 2) {
    bounds.left = Math.min(bounds.left, points[i]);
    bounds.bottom = Math.min(bounds.bottom, points[i + 1]);
    bounds.right = Math.max(bounds.right, points[i]);
    bounds.top = Math.max(bounds.top, points[i + 1]);
  }
  return bounds;
}
function widened({left, bottom, right, top}, by) {
  return {left: left - by, bottom: bottom - by, right: right + by, top: top + by};
}
function middleOf({left, bottom, right, top}) {
  return {x: 0.5 * (left + right), y: 0.5 * (bottom + top)};
}
function coreOf({left, bottom, right, top}) {
  const across = Math.min(kSpill, 0.5 * (right - left));
  return {left: left + across, bottom: bottom + kSpill, right: right - across, top: top - kSpill};
}
function clamp(value, low, high) {
  return Math.min(Math.max(value, low), high);
}
function touch(a, b) {
  return a.left <= b.right && b.left <= a.right && a.bottom <= b.top && b.bottom <= a.top;
}
// Most time goes here, so that it makes no arrays.
function crosses(x0, y0, x1, y1, {left, bottom, right, top}) {
  const dx = x1 - x0, dy = y1 - y0;
  let from = 0, to = 1;
  if (dx === 0) {
    if (x0 < left || x0 > right) return false;
  } else {
    const a = (left - x0) / dx, b = (right - x0) / dx;
    from = Math.max(from, Math.min(a, b));
    to = Math.min(to, Math.max(a, b));
    if (from > to) return false;
  }
  if (dy === 0) return y0 >= bottom && y0 <= top;
  const a = (bottom - y0) / dy, b = (top - y0) / dy;
  return Math.max(from, Math.min(a, b)) <= Math.min(to, Math.max(a, b));
}
function contains(thing, x, y) {
  const {left, bottom, right, top, form, points} = thing;
  if (x < left || x > right || y < bottom || y > top) return false;
  if (form === kCircleForm) return (x - 0.5 * (left + right)) ** 2 + (y - 0.5 * (bottom + top)) ** 2 <= (0.5 * (right - left)) ** 2;
  if (form === kBoxForm) return true;
  let isInside = false;
  for (let i = 0, j = points.length - 2; i < points.length; j = i, i += 2) {
    const ay = points[j + 1], by = points[i + 1];
    if (ay > y !== by > y && x < points[j] + (y - ay) / (by - ay) * (points[i] - points[j])) isInside = !isInside;
  }
  return isInside;
}
// Calls `visit` for each side of a closed polygon.
function eachSide(points, visit) {
  const count = points.length;
  for (let i = 0; i < count; i += 2) visit(points[i], points[i + 1], points[(i + 2) % count], points[(i + 3) % count]);
}
// The distance of the closest parallel lines around it.
function thicknessOf({left, bottom, right, top, form, points}) {
  let thickness = Math.min(right - left, top - bottom);
  if (form !== kLinesForm) return thickness;
  eachSide(points, (ax, ay, bx, by) => {
    const length = Math.hypot(bx - ax, by - ay);
    if (length === 0) return;
    let least = 0, most = 0;
    for (let i = 0; i < points.length; i += 2) {
      const away = ((bx - ax) * (points[i + 1] - ay) - (by - ay) * (points[i] - ax)) / length;
      least = Math.min(least, away);
      most = Math.max(most, away);
    }
    thickness = Math.min(thickness, most - least);
  });
  return thickness;
}
function strikes(thing, box) {
  const isLonger = thing.left < box.left || thing.bottom < box.bottom || thing.right > box.right || thing.top > box.top;
  if (!isLonger || !meets(thing, box)) return false;
  const thickness = thicknessOf(thing);
  return thickness < kLetterHeight && Math.hypot(thing.right - thing.left, thing.top - thing.bottom) > kSlender * thickness;
}
function meets(thing, box) {
  if (thing.form === kCircleForm) {
    const {x, y} = middleOf(thing);
    return contains(thing, clamp(x, box.left, box.right), clamp(y, box.bottom, box.top));
  }
  if (thing.form === kBoxForm) {
    return thing.left < box.right - kRounding && box.left < thing.right - kRounding &&
           thing.bottom < box.top - kRounding && box.bottom < thing.top - kRounding;
  }
  const {points} = thing, count = points.length;
  for (let i = 0, j = count - 2; i < count; j = i, i += 2) {
    if (crosses(points[j], points[j + 1], points[i], points[i + 1], box)) return true;
  }
  return contains(thing, 0.5 * (box.left + box.right), 0.5 * (box.bottom + box.top));
}
