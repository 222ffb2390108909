// Draws a frame on a canvas as `boxreel shot` does. The view says where the middle of the canvas is [m]
// and how large a metre is [device px]; `ratio` multiplies all widths in pixels.

// Coordinates far outside lose precision in a browser, so shapes are cut here [px].
const kGuard = 4096;
const kMitreLimit = 2.01; // corners sharper than 60 degrees are cut off
const kTextLine = 15, kTextSize = 15 * 2048 / 2384, kTextAscent = 12; // [px]

class Painter {
  constructor(film) {
    this.film = film;
    this.world = new Float64Array(64);
    this.pixels = new Float64Array(64);
  }
  // look: {view: {x, y, scale}, ratio, theme, hidden: Set of layers, marked: number of a body or -1}
  draw(canvas, frame, look) {
    const context = canvas.getContext("2d", {alpha: false});
    this.context = context;
    this.look = look;
    this.width = canvas.width;
    this.height = canvas.height;
    this.lineWidth = look.theme.lineWidth * look.ratio;
    this.stroke = this.fill = null;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = look.theme.background;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.lineWidth = this.lineWidth;
    context.lineCap = "round";
    context.lineJoin = "miter";
    context.miterLimit = kMitreLimit;
    let at = 0;
    for (const track of frame.tracks) {
      if (!look.hidden.has(this.film.styles[track.style])) this.drawTrack(track, frame.numbers, at);
      at += track.form.numbers;
    }
  }
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
    for (const item of form.items) {
      this.drawItem(item, this.pixels.subarray(first, first + 2 * item.count), track);
      first += 2 * item.count;
    }
  }
  // Without styles that are set already: browsers read colours anew each time.
  setStroke(color) {
    if (color !== this.stroke) this.context.strokeStyle = this.stroke = color;
  }
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
    const size = Math.abs(item.size);
    const isRound = item.kind === kCircle || item.kind === kSolidCircle || item.kind === kTransform;
    const isText = item.kind === kText;
    const reach = 3 * this.lineWidth + (isRound ? size * view.scale : size * ratio);
    if (!isText && this.isOutside(points, reach)) return;
    const stroke = theme.strokes[track.style];
    switch (item.kind) {
      case kPolygon:
        this.setStroke(stroke);
        this.outline(points);
        break;
      case kSolidPolygon:
        this.setStroke(stroke);
        this.solid(points, theme.fills[track.style]);
        break;
      case kCircle:
        this.setStroke(stroke);
        this.circle(points, size * view.scale, null);
        break;
      case kSolidCircle:
        this.setStroke(stroke);
        this.circle(points, size * view.scale, theme.fills[track.style]);
        this.line(points[0], points[1], points[2], points[3]);
        break;
      case kSegment:
        this.setStroke(stroke);
        this.line(points[0], points[1], points[2], points[3]);
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
  path(points) {
    const {context} = this;
    context.beginPath();
    context.moveTo(points[0], points[1]);
    for (let i = 2; i < points.length; i += 2) context.lineTo(points[i], points[i + 1]);
    context.closePath();
  }
  solid(points, fill) {
    const {context} = this;
    if (this.isFar) points = cutPolygon(points, -kGuard, -kGuard, this.width + kGuard, this.height + kGuard);
    if (points.length < 2) return;
    this.path(points);
    this.setFill(fill);
    context.fill();
    context.stroke();
  }
  outline(points) {
    const count = points.length / 2;
    if (!this.isFar && count > 2) {
      this.context.lineJoin = "round";
      this.path(points);
      this.context.stroke();
      this.context.lineJoin = "miter";
      return;
    }
    for (let i = 0; i < (count === 2 ? 1 : count); ++i) {
      const next = (i + 1) % count;
      this.line(points[2 * i], points[2 * i + 1], points[2 * next], points[2 * next + 1]);
    }
  }
  circle(points, radius, fill) {
    const {context} = this;
    context.beginPath();
    context.arc(points[0], points[1], radius, 0, 2 * Math.PI);
    if (fill !== null) {
      this.setFill(fill);
      context.fill();
    }
    context.stroke();
  }
  dot(points, radius, color) {
    this.setFill(color);
    this.context.beginPath();
    this.context.arc(points[0], points[1], radius, 0, 2 * Math.PI);
    this.context.fill();
  }
  line(x0, y0, x1, y1) {
    const part = cutLine(x0, y0, x1, y1, -kGuard, -kGuard, this.width + kGuard, this.height + kGuard);
    if (!part) return;
    this.context.beginPath();
    this.context.moveTo(part[0], part[1]);
    this.context.lineTo(part[2], part[3]);
    this.context.stroke();
  }
  axes([x, y, xEnd, yEnd]) {
    this.setStroke(this.look.theme.xAxis);
    this.line(x, y, xEnd, yEnd);
    this.setStroke(this.look.theme.yAxis);
    this.line(x, y, x + (yEnd - y), y - (xEnd - x)); // a quarter turn to the left, with y down
  }
  text(points, text, color) {
    const {context, look: {ratio}} = this;
    this.setFill(color);
    context.font = `${kTextSize * ratio}px "DejaVu Sans", sans-serif`;
    const x = Math.floor(points[0] + 0.5);
    let y = Math.floor(points[1] + 0.5) + kTextAscent * ratio;
    for (const line of text.split("\n")) {
      context.fillText(line, x, y);
      y += kTextLine * ratio;
    }
  }
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
  let corners = [...points];
  for (const [axis, limit, sign] of [[0, left, 1], [0, right, -1], [1, top, 1], [1, bottom, -1]]) {
    const kept = [];
    for (let i = 0; i < corners.length; i += 2) {
      const j = (i + 2) % corners.length;
      const here = sign * (corners[i + axis] - limit), there = sign * (corners[j + axis] - limit);
      if (here >= 0) kept.push(corners[i], corners[i + 1]);
      if (here >= 0 !== there >= 0) {
        const share = here / (here - there);
        kept.push(corners[i] + share * (corners[j] - corners[i]), corners[i + 1] + share * (corners[j + 1] - corners[i + 1]));
      }
    }
    corners = kept;
  }
  return corners;
}
