// Draws a frame on a canvas as `boxreel shot` does. The view says where the middle of the canvas is [m]
// and how large a metre is [px]; `ratio` multiplies the widths of lines, points and letters.

// Coordinates far outside lose precision in a browser, so shapes are cut here [px].
const kGuard = 4096;
const kSpeck = 20000;            // [px]
const kMitreLimit = 2;           // sharper corners are cut at so many half widths of a line
const kSquareEnd = Math.PI / 4;  // of a line, in half widths
const kTextLine = 15, kTextSize = 15 * 2048 / 2384, kTextAscent = 12; // [px]
const kFontFamily = '"DejaVu Sans", sans-serif';

const kMostDashes = 400;
const kFarthestShape = 1000; // of a name, see WorldBodies.cpp [px]
const kShortest = 1.5; // shorter arrows are not drawn, as in films [px]
// Lengths of arrow heads, by layer [px].
const kHeads = {[kImpulses]: 7, [kFriction]: 7, [kVelocities]: 9, [kForces]: 9};

class Painter {
  constructor(film) {
    this.film = film;
    this.world = new Float64Array(64);
    this.pixels = new Float64Array(64);
    this.letters = new Map(); // by their sign
  }
  // look: {view: {x, y, scale}, ratio, theme, hidden: Set of layers}
  draw(canvas, frame, look) {
    this.look = look;
    this.width = canvas.width;
    this.height = canvas.height;
    this.lineWidth = look.theme.lineWidth * look.ratio;
    // What is that many pixels in the film keeps its size where labels need it.
    this.labelScale = look.ratio * this.film.viewOf(frame).scale / look.view.scale;
    this.shaft = null; // of the arrow head that follows
    if (this.letterRatio !== look.ratio) this.letters.clear();
    this.letterRatio = look.ratio;
    this.begin(canvas);
    this.wishes = []; // names, which are placed when all that may be in their way is known
    const isNamed = !look.hidden.has(kLabels) && frame.tracks.some(track => this.isWish(track, track.form.items[0]));
    this.things = isNamed ? [] : null;
    let at = 0;
    for (const track of frame.tracks) {
      if (!look.hidden.has(this.film.styles[track.style])) this.drawTrack(track, frame.numbers, at);
      at += track.form.numbers;
    }
    this.wishes = this.wishes.filter(wish => !wish.needsShape || this.hasShapeNear(wish, frame));
    this.drawNames(this.wishes.filter(wish => wish.owner >= 0));
    this.drawNames(this.wishes.filter(wish => wish.owner < 0));
    this.end(canvas);
  }
  isWish(track, item) {
    return this.film.styles[track.style] === kLabels && item?.kind === kText && item.size > 0;
  }
  begin(canvas) {
    this.context = canvas.getContext("2d", {alpha: false});
    this.context.fillStyle = this.fill = this.look.theme.background;
    this.context.fillRect(0, 0, canvas.width, canvas.height);
  }
  end() {}
  drawTrack(track, numbers, at) {
    const form = track.form;
    if (this.world.length < 2 * form.pointCount) {
      this.world = new Float64Array(4 * form.pointCount);
      this.pixels = new Float64Array(4 * form.pointCount);
    }
    placePoints(form, numbers, at, this.film.quantum, this.world);
    const {view} = this.look;
    for (let i = 0; i < 2 * form.pointCount; i += 2) {
      this.pixels[i] = 0.5 * this.width + (this.world[i] - view.x) * view.scale;
      this.pixels[i + 1] = 0.5 * this.height - (this.world[i + 1] - view.y) * view.scale;
    }
    let first = 0;
    const layer = this.film.styles[track.style];
    for (const item of form.items) {
      const points = this.pixels.subarray(first, first + 2 * item.count);
      this.drawSized(item, points, track, layer);
      first += 2 * item.count;
    }
  }
  // What films draw in pixels keeps its size at every zoom: labels, arrow heads, normals, marks.
  drawSized(item, points, track, layer) {
    if (kHeads[layer]) return this.arrowPart(item, points, track, kHeads[layer] * this.look.ratio, layer === kFriction);
    if (layer === kGlyphs) return this.glyphPart(item, points, track);
    if (this.isWish(track, item)) return this.addWish(item, points, track);
    if (layer === kNormals) scaleAbout(points, points[0], points[1], this.labelScale);
    if (layer === kCenterMarks) {
      scaleAbout(points, points[0], points[1], this.labelScale);
      if (item.kind === kCircle) item = {...item, size: item.size * this.labelScale};
    }
    this.drawItem(item, points, track);
  }
  addWish({text, size}, points, track) {
    const {view, ratio, theme} = this.look, letters = this.film.texts[text];
    // As films, which compute with floats of the world: far from its origin that is a pixel.
    const worldX = Math.fround(view.x + (points[0] - 0.5 * this.width) / view.scale);
    const worldY = Math.fround(view.y + (0.5 * this.height - points[1]) / view.scale);
    this.wishes.push({x: (worldX - view.x) * view.scale / ratio, y: (worldY - view.y) * view.scale / ratio,
                      width: this.widthOf(letters) / ratio, owner: track.owner, text: letters, stroke: theme.strokes[track.style],
                      needsShape: size > 1});
  }
  // Bodies that rest have names only while a shape of theirs is near the picture.
  hasShapeNear({owner}, frame) {
    const {view, ratio} = this.look, reach = kFarthestShape * ratio;
    let isNear = false;
    eachShape(this.film, frame, (item, points, body) => {
      if (body !== owner || isNear) return;
      const size = item.kind === kCircle || item.kind === kSolidCircle ? Math.abs(item.size) : 0;
      const {left, bottom, right, top} = boundsOf(points.subarray(0, item.kind === kSolidCircle ? 2 : points.length));
      isNear = (right + size - view.x) * view.scale >= -0.5 * this.width - reach && (left - size - view.x) * view.scale <= 0.5 * this.width + reach &&
               (top + size - view.y) * view.scale >= -0.5 * this.height - reach && (bottom - size - view.y) * view.scale <= 0.5 * this.height + reach;
    });
    return isNear;
  }
  // Pixels of CSS from the middle of the canvas, y up, as labels are placed.
  fromMiddle(points, count) {
    const {ratio} = this.look, own = new Float64Array(count);
    for (let i = 0; i < count; i += 2) {
      own[i] = (points[i] - 0.5 * this.width) / ratio;
      own[i + 1] = (0.5 * this.height - points[i + 1]) / ratio;
    }
    return own;
  }
  // Lines and arrows that leave text legible are not in the way of names.
  addThing(item, points, {owner}, layer) {
    const isSign = layer === kGlyphs || layer === kCenters || layer === kCenterMarks || layer === kAnnotations || layer === kLabels;
    if (!isSign && layer !== kShapes) return;
    const {view, ratio} = this.look;
    const isText = item.kind === kText, isCircle = item.kind === kCircle || item.kind === kSolidCircle;
    const role = layer === kShapes ? kShape : isText ? kLabel : kSign;
    // The second point of these two is on the circle or the axis.
    const own = this.fromMiddle(points, item.kind === kSolidCircle || item.kind === kTransform ? 2 : points.length);
    const reach = item.kind === kPoint ? 0.5 * item.size : isCircle || item.kind === kTransform ? item.size * view.scale / ratio : 0;
    const bounds = widened(boundsOf(own), reach);
    if (isText) {
      bounds.right += this.widthOf(this.film.texts[item.text]) / ratio;
      bounds.bottom -= kTextLine;
    }
    const form = isCircle ? kCircleForm : item.kind <= kSegment ? kLinesForm : kBoxForm;
    this.things.push({role, form, owner, points: own, ...bounds});
  }
  drawNames(wishes) {
    if (wishes.length === 0) return;
    const {ratio, theme, view} = this.look, width = this.width / ratio, height = this.height / ratio, scale = view.scale / ratio;
    const obstacles = new LabelObstacles(width, height);
    for (const thing of this.things) obstacles.add(thing);
    const toCanvas = (x, y) => [ratio * (0.5 * width + x), ratio * (0.5 * height - y)];
    new LabelSpots(obstacles).settle(wishes).forEach((spot, i) => {
      if (!spot) return;
      const {x, y, owner, text, stroke} = wishes[i];
      if (spot.tie) {
        this.line(...toCanvas(x, y), ...toCanvas(...spot.tie), theme.nameLine);
        const points = [x, y, ...spot.tie];
        this.things.push({role: kSign, form: kLinesForm, owner, points, ...boundsOf(points)});
      }
      // Its corner in the world, rounded as films round it.
      const cornerX = Math.fround(Math.fround(view.x + spot.x / scale) - 0.5 * wishes[i].width / scale);
      const cornerY = Math.fround(Math.fround(view.y + spot.y / scale) + 0.5 * kTextLine / scale);
      let left = 0.5 * width + (cornerX - view.x) * scale, top = 0.5 * height - (cornerY - view.y) * scale;
      const safeLeft = offEdge(left), safeTop = offEdge(top);
      if (safeLeft !== left) left = 0.5 * width + (Math.fround(view.x + (safeLeft - 0.5 * width) / scale) - view.x) * scale;
      if (safeTop !== top) top = 0.5 * height - (Math.fround(view.y + (0.5 * height - safeTop) / scale) - view.y) * scale;
      this.text([ratio * left, ratio * top], text, stroke);
      this.things.push({role: kLabel, form: kBoxForm, owner, left: left - 0.5 * width, bottom: 0.5 * height - top - kTextLine,
                        right: left - 0.5 * width + wishes[i].width, top: 0.5 * height - top});
    });
  }
  // A part of a joint's sign: its points, and behind them their anchors, from which they are some
  // pixels away.
  glyphPart(item, points, track) {
    if (item.kind === kCircle) item = {...item, size: item.size * this.labelScale};
    else if (item.kind !== kPoint) {
      const count = points.length / 2;
      if (item.kind === kSegment && !this.isForm(item, points.subarray(count))) return;
      for (let i = 0; i < count && this.labelScale !== 1; ++i) {
        points[i] = points[count + i] + this.labelScale * (points[i] - points[count + i]);
      }
      const anchors = points.subarray(count);
      points = points.subarray(0, count);
      if (item.kind === kPolygon && item.size > 0) return this.dashes(item.size, points, anchors, track);
    }
    this.drawItem(item, points, track);
  }
  // Of a line between signs, which there is only where they leave room for it.
  dashes(dash, [x0, y0, x1, y1], anchors, track) {
    const dx = x1 - x0, dy = y1 - y0;
    if (dx * (anchors[2] - anchors[0]) + dy * (anchors[3] - anchors[1]) < 0) return;
    const count = 2 * Math.trunc(Math.min(0.5 * Math.hypot(dx, dy) / this.look.ratio / dash, kMostDashes)) + 1;
    for (let i = 0; i < count; i += 2) {
      const from = i / count, to = (i + 1) / count;
      this.drawItem({kind: kSegment, size: 0}, [x0 + from * dx, y0 + from * dy, x0 + to * dx, y0 + to * dy], track);
    }
  }
  // Springs have two forms: lines, of a size below 0, and behind them a zigzag, from a length on [px].
  isForm({size}, ends) {
    if (size < 0) this.spring = lengthOf(ends) / this.look.ratio;
    return size === 0 || (size < 0 ? this.spring < -size : this.spring >= size);
  }
  // A shaft, and behind it its head: a triangle, or two lines from its tip where it is open. An arrow
  // that is short has a smaller head, and one as long as its head no shaft.
  arrowPart(item, points, track, wanted, isOpen) {
    const {shaft} = this, shortest = kShortest * this.look.ratio;
    if (item.kind === kSegment) {
      const isHead = isOpen && shaft && Math.hypot(points[2] - shaft[2], points[3] - shaft[3]) < 0.01;
      if (isHead) {
        const along = alongShaft(points, shaft);
        scaleAbout(points, shaft[2], shaft[3], Math.min(wanted, lengthOf(shaft)) / along);
      }
      this.shaft = isHead ? shaft : points.slice();
      if (isOpen && lengthOf(this.shaft) >= shortest) this.drawItem(item, points, track);
      return;
    }
    const [tipX, tipY] = points, baseX = 0.5 * (points[2] + points[4]), baseY = 0.5 * (points[3] + points[5]);
    const isOwn = shaft && Math.hypot(shaft[2] - baseX, shaft[3] - baseY) < 0.01 * this.look.ratio + 1e-3 * this.look.view.scale;
    const line = isOwn ? shaft : new Float64Array([baseX, baseY, tipX, tipY]);
    line[2] = tipX;
    line[3] = tipY;
    const along = Math.hypot(tipX - baseX, tipY - baseY), length = lengthOf(line), head = Math.min(wanted, length);
    this.shaft = null;
    if (length < shortest) return;
    if (head < length * (1 - 1e-6)) {
      line[2] = tipX - head / length * (tipX - line[0]);
      line[3] = tipY - head / length * (tipY - line[1]);
      this.drawItem({kind: kSegment, size: 0}, line, track);
    }
    scaleAbout(points, tipX, tipY, head / along);
    this.drawItem(item, points, track);
  }
  // Does not set the same colour twice, because browsers parse it again each time.
  setFill(color) {
    if (color !== this.fill) this.context.fillStyle = this.fill = color;
  }
  isOutside(points, reach) {
    let left = Infinity, right = -Infinity, top = Infinity, bottom = -Infinity;
    for (let i = 0; i < points.length; i += 2) {
      left = Math.min(left, points[i]);
      right = Math.max(right, points[i]);
      top = Math.min(top, points[i + 1]);
      bottom = Math.max(bottom, points[i + 1]);
    }
    this.isFar = left < -kGuard || top < -kGuard || right > this.width + kGuard || bottom > this.height + kGuard;
    return right < -reach || bottom < -reach || left > this.width + reach || top > this.height + reach;
  }
  drawItem(item, points, track) {
    const {theme, view, ratio} = this.look;
    if (this.things) this.addThing(item, points, track, this.film.styles[track.style]);
    const size = Math.abs(item.size);
    const isRound = item.kind === kCircle || item.kind === kSolidCircle || item.kind === kTransform;
    const isText = item.kind === kText;
    const reach = 3 * this.lineWidth + (isRound ? size * view.scale : size * ratio);
    if (!isText && this.isOutside(points, reach)) return;
    const stroke = theme.strokes[track.style];
    switch (item.kind) {
      case kPolygon:
        this.outline(points, stroke);
        break;
      case kSolidPolygon:
        this.solid(points, theme.fills[track.style], stroke);
        break;
      case kCircle:
        this.circle(points, size * view.scale, null, stroke);
        break;
      case kSolidCircle:
        this.circle(points, size * view.scale, theme.fills[track.style], stroke);
        this.line(points[0], points[1], points[2], points[3], stroke);
        break;
      case kSegment:
        this.line(points[0], points[1], points[2], points[3], stroke);
        break;
      case kTransform:
        this.axes(points);
        break;
      case kPoint:
        this.dot(points, 0.5 * size * ratio, stroke);
        break;
      case kText:
        this.text(points, this.film.texts[item.text], stroke);
        break;
    }
  }
  // Browsers that draw without a graphics processor count few samples in a small path; a speck far
  // outside makes it a large one, which they draw exactly.
  fillRings(rings, color) {
    const {context} = this;
    context.beginPath();
    context.moveTo(-kSpeck, -kSpeck);
    context.lineTo(-kSpeck, 1 - kSpeck);
    context.closePath();
    for (const ring of rings) this.addRing(ring);
    this.setFill(color);
    context.fill("evenodd");
  }
  // A closed polygon, or a circle.
  addRing(ring) {
    const {context} = this;
    if (ring.radius) {
      context.moveTo(ring.x + ring.radius, ring.y);
      context.arc(ring.x, ring.y, ring.radius, 0, 2 * Math.PI);
    } else {
      context.moveTo(ring[0], ring[1]);
      for (let i = 2; i < ring.length; i += 2) context.lineTo(ring[i], ring[i + 1]);
    }
    context.closePath();
  }
  solid(points, fill, stroke) {
    if (this.isFar) points = cutPolygon(points, -kGuard, -kGuard, this.width + kGuard, this.height + kGuard);
    points = convex(points);
    if (points.length < 6) return this.outline(points, stroke); // no area
    const inner = shrink(points, 0.5 * this.lineWidth);
    this.fillSolid(grow(points, 0.5 * this.lineWidth), points, inner.length > 0 ? inner : null, fill, stroke);
  }
  // The fill up to the middle of the outline, and the outline over it: where both share a pixel it has
  // the colours that renderers give it.
  fillSolid(outer, middle, inner, fill, stroke) {
    if (inner && fill !== null) this.fillRings([middle], fill);
    this.fillRings(inner ? [outer, inner] : [outer], stroke);
  }
  outline(points, stroke) {
    const count = points.length / 2;
    for (let i = 0; i < (count === 2 ? 1 : count); ++i) {
      const next = (i + 1) % count;
      this.line(points[2 * i], points[2 * i + 1], points[2 * next], points[2 * next + 1], stroke);
    }
  }
  circle([x, y], radius, fill, stroke) {
    const half = 0.5 * this.lineWidth, inner = radius > half ? {x, y, radius: radius - half} : null;
    this.fillSolid({x, y, radius: radius + half}, {x, y, radius}, inner, fill, stroke);
  }
  dot([x, y], radius, color) {
    if (radius > 0) this.fillRings([{x, y, radius}], color);
  }
  // With square ends that have the area of round ones.
  line(x0, y0, x1, y1, color) {
    const part = cutLine(x0, y0, x1, y1, -kGuard, -kGuard, this.width + kGuard, this.height + kGuard);
    if (!part) return;
    [x0, y0, x1, y1] = part;
    const length = Math.hypot(x1 - x0, y1 - y0), half = 0.5 * this.lineWidth;
    const ux = length > 0 ? half * (x1 - x0) / length : half, uy = length > 0 ? half * (y1 - y0) / length : 0;
    const ex = kSquareEnd * ux, ey = kSquareEnd * uy;
    this.fillRings([[x0 - ex - uy, y0 - ey + ux, x1 + ex - uy, y1 + ey + ux,
                     x1 + ex + uy, y1 + ey - ux, x0 - ex + uy, y0 - ey - ux]], color);
  }
  axes([x, y, xEnd, yEnd]) {
    const {theme} = this.look;
    this.line(x, y, xEnd, yEnd, theme.xAxis);
    this.line(x, y, x + (yEnd - y), y - (xEnd - x), theme.yAxis); // a quarter turn to the left, with y down
  }
  // Letters begin at whole pixels, as those of renderers do.
  text(points, text, color) {
    const {ratio} = this.look;
    let x = Math.floor(points[0] + 0.5), y = Math.floor(points[1] + 0.5);
    for (const line of text.split("\n")) {
      let pen = x;
      for (const letter of this.lettersOf(line)) {
        this.letter(letter, Math.floor(pen + 0.5), Math.floor(y + 0.5), color);
        pen += letter.advance;
      }
      y += kTextLine * ratio;
    }
  }
  letter({sign}, x, y, color) {
    const {context, look: {ratio}} = this;
    this.setFill(color);
    context.font = `${kTextSize * ratio}px ${kFontFamily}`;
    context.fillText(sign, x, y + Math.round(kTextAscent * ratio));
  }
  lettersOf(text) {
    return Array.from(text, sign => this.letters.get(sign) ?? this.addLetter(sign));
  }
  // Letters are whole pixels apart in the film.
  addLetter(sign) {
    const pen = document.createElement("canvas").getContext("2d"), {ratio} = this.look;
    pen.font = `2048px ${kFontFamily}`;
    const width = pen.measureText(sign).width * (kTextLine / 2384);
    const letter = {sign, width: width * ratio, advance: Math.round(width) * ratio};
    this.letters.set(sign, letter);
    return letter;
  }
  // As the film placed it.
  widthOf(text) {
    const sum = key => this.lettersOf(text).reduce((width, letter) => width + letter[key], 0);
    return Math.max(sum("width"), sum("advance"));
  }
}

function scaleAbout(points, x, y, factor) {
  if (factor === 1) return;
  for (let i = 0; i < points.length; i += 2) {
    points[i] = x + factor * (points[i] - x);
    points[i + 1] = y + factor * (points[i + 1] - y);
  }
}

function lengthOf([x0, y0, x1, y1]) {
  return Math.hypot(x1 - x0, y1 - y0);
}

// How far the first point is behind the tip of the shaft, along it.
function alongShaft([x, y], shaft) {
  const length = lengthOf(shaft);
  return ((shaft[2] - x) * (shaft[2] - shaft[0]) + (shaft[3] - y) * (shaft[3] - shaft[1])) / length;
}

// The part of a line within a rectangle, or null.
function cutLine(x0, y0, x1, y1, left, top, right, bottom) {
  let from = 0, to = 1;
  const dx = x1 - x0, dy = y1 - y0;
  for (const [step, room] of [[-dx, x0 - left], [dx, right - x0], [-dy, y0 - top], [dy, bottom - y0]]) {
    if (step === 0) {
      if (room < 0) return null;
    } else if (step < 0) {
      from = Math.max(from, room / step);
    } else {
      to = Math.min(to, room / step);
    }
  }
  return from > to ? null : [x0 + from * dx, y0 + from * dy, x0 + to * dx, y0 + to * dy];
}

// The part of a convex polygon within a rectangle (Sutherland and Hodgman, 1974).
function cutPolygon(points, left, top, right, bottom) {
  const sides = [x => x - left, x => right - x, (x, y) => y - top, (x, y) => bottom - y];
  return sides.reduce(cutHalf, [...points]);
}

// Without repeated corners, and counter-clockwise where y points down.
function convex(points) {
  const kept = [];
  for (let i = 0; i < points.length; i += 2) {
    const next = (i + 2) % points.length;
    if (points[i] !== points[next] || points[i + 1] !== points[next + 1]) kept.push(points[i], points[i + 1]);
  }
  let area = 0;
  for (let i = 0; i < kept.length; i += 2) {
    const next = (i + 2) % kept.length;
    area += kept[i] * kept[next + 1] - kept[next] * kept[i + 1];
  }
  if (area === 0) return kept.slice(0, 4);
  if (area > 0) return kept;
  const turned = [];
  for (let i = kept.length - 2; i >= 0; i -= 2) turned.push(kept[i], kept[i + 1]);
  return turned;
}

// Calls `visit(x, y, nx, ny, mx, my)` for each corner of a convex polygon: the outward normals of the
// edges before and behind it.
function eachCorner(points, visit) {
  const count = points.length;
  const normal = i => {
    const j = (i + 2) % count;
    const dx = points[j] - points[i], dy = points[j + 1] - points[i + 1], length = Math.hypot(dx, dy);
    return [dy / length, -dx / length];
  };
  let before = normal(count - 2);
  for (let i = 0; i < count; i += 2) {
    const behind = normal(i);
    visit(points[i], points[i + 1], before[0], before[1], behind[0], behind[1]);
    before = behind;
  }
}

// Moves the edges of a convex polygon outwards.
function grow(points, distance) {
  const grown = [];
  eachCorner(points, (x, y, nx, ny, mx, my) => {
    const share = 1 + nx * mx + ny * my; // 2 cos^2 of half the angle between the normals
    const isSharp = share * kMitreLimit * kMitreLimit < 2;
    if (!isSharp) {
      grown.push(x + distance * (nx + mx) / share, y + distance * (ny + my) / share);
      return;
    }
    // Cut across the middle of the corner.
    const cosine = Math.sqrt(Math.max(share / 2, 0)), sine = Math.sqrt(Math.max(1 - share / 2, 0));
    const along = distance * (kMitreLimit - cosine) / sine;
    grown.push(x + distance * nx - along * ny, y + distance * ny + along * nx,
               x + distance * mx + along * my, y + distance * my - along * mx);
  });
  return grown;
}

// Moves the edges of a convex polygon inwards; nothing may be left.
function shrink(points, distance) {
  const shrunk = [];
  eachCorner(points, (x, y, nx, ny, mx, my) => {
    const share = 1 + nx * mx + ny * my;
    shrunk.push(x - distance * (nx + mx) / share, y - distance * (ny + my) / share);
  });
  for (let i = 0; i < points.length; i += 2) {
    const j = (i + 2) % points.length;
    const isTurned = (points[j] - points[i]) * (shrunk[j] - shrunk[i]) +
                     (points[j + 1] - points[i + 1]) * (shrunk[j + 1] - shrunk[i + 1]) <= 0;
    if (isTurned) return cutEdges(points, distance);
  }
  return shrunk;
}

// The same where an edge vanishes: what is left behind all edges.
function cutEdges(points, distance) {
  let left = [...points];
  for (let i = 0; i < points.length && left.length > 0; i += 2) {
    const j = (i + 2) % points.length;
    const dx = points[j] - points[i], dy = points[j + 1] - points[i + 1], length = Math.hypot(dx, dy);
    const nx = dy / length, ny = -dx / length;
    const limit = nx * points[i] + ny * points[i + 1] - distance;
    left = cutHalf(left, (x, y) => limit - nx * x - ny * y);
  }
  return left.length < 6 ? [] : left;
}

// The part of a polygon where `inside(x, y)`, a distance, is not negative.
function cutHalf(corners, inside) {
  const kept = [];
  for (let i = 0; i < corners.length; i += 2) {
    const j = (i + 2) % corners.length;
    const here = inside(corners[i], corners[i + 1]), there = inside(corners[j], corners[j + 1]);
    if (here >= 0) kept.push(corners[i], corners[i + 1]);
    if (here >= 0 !== there >= 0) {
      const share = here / (here - there);
      kept.push(corners[i] + share * (corners[j] - corners[i]), corners[i + 1] + share * (corners[j + 1] - corners[i + 1]));
    }
  }
  return kept;
}
