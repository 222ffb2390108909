// Draws a resting picture as renderers do: each item by the area that it covers of a pixel, blended over
// those before it in steps of 1/255. Canvases place edges less exactly. Too slow to play.

const kSag = 0.005;      // between a circle and its polygon [px]
const kLetterScale = 32; // browsers draw letters of that size from their outlines, without hints [film px]

class ExactPainter extends Painter {
  begin(canvas) {
    const {width, height} = canvas;
    if (this.image?.width !== width || this.image?.height !== height) {
      this.image = new ImageData(width, height);
      this.stride = width + 2;
      // Of the item: how much the area covered by its outside and its inside grows from column to column.
      this.outer = new Float32Array(this.stride * height);
      this.inner = new Float32Array(this.stride * height);
      this.from = new Int32Array(height).fill(width + 1); // columns of a row that it covers
      this.to = new Int32Array(height).fill(-1);
      this.colors = new Map();
    }
    const [r, g, b] = this.colorOf(this.look.theme.background);
    new Uint32Array(this.image.data.buffer).fill(r | g << 8 | b << 16 | 255 << 24);
  }
  end(canvas) {
    canvas.getContext("2d", {alpha: false}).putImageData(this.image, 0, 0);
  }
  // Of CSS, multiplied by its opacity; of none, nothing.
  colorOf(text) {
    const known = this.colors.get(text);
    if (known) return known;
    const [r, g, b, a = 1] = text ? text.match(/[\d.]+/g).map(Number) : [0, 0, 0, 0];
    const color = [a * r, a * g, a * b, a];
    this.colors.set(text, color);
    return color;
  }
  fillRings([ring], color) {
    this.fillSolid(ring, null, null, null, color);
  }
  fillSolid(outer, middle, inner, fill, stroke) {
    this.top = this.image.height;
    this.bottom = -1;
    this.addEdges(outer, this.outer);
    if (inner) this.addEdges(inner, this.inner);
    this.blend(this.colorOf(stroke), this.colorOf(fill));
  }
  addEdges(ring, area) {
    const points = ring.radius ? polygonOf(ring) : ring;
    for (let i = 0, j = points.length - 2; i < points.length; j = i, i += 2) {
      this.addEdge(points[j], points[j + 1], points[i], points[i + 1], area);
    }
  }
  // Within the picture; what is beside it moves to its side.
  addEdge(x0, y0, x1, y1, area) {
    if (y0 === y1) return;
    const sign = y0 < y1 ? 1 : -1;
    if (sign < 0) [x0, y0, x1, y1] = [x1, y1, x0, y0];
    const {width, height} = this.image, slope = (x1 - x0) / (y1 - y0);
    const first = Math.max(y0, 0), last = Math.min(y1, height);
    if (first >= last) return;
    const xAt = y => x0 + (y - y0) * slope, inside = y => Math.min(Math.max(y, first), last);
    const sides = slope === 0 ? [first, last] : [inside(y0 - x0 / slope), inside(y0 + (width - x0) / slope)];
    const ends = [first, Math.min(...sides), Math.max(...sides), last];
    for (let k = 0; k < 3; ++k) {
      const a = ends[k], b = ends[k + 1];
      if (a >= b) continue;
      const middle = xAt(0.5 * (a + b)), side = middle < 0 ? 0 : width;
      if (middle < 0 || middle >= width) this.addPart(side, a, side, b, sign, area);
      else this.addPart(xAt(a), a, xAt(b), b, sign, area);
    }
  }
  addPart(x0, y0, x1, y1, sign, area) {
    const {width} = this.image, slope = (x1 - x0) / (y1 - y0);
    const clamp = x => Math.min(Math.max(x, 0), width);
    this.top = Math.min(this.top, Math.floor(y0));
    for (let row = Math.floor(y0); row < y1; ++row) {
      const a = Math.max(row, y0), b = Math.min(row + 1, y1);
      const xa = clamp(x0 + (a - y0) * slope), xb = clamp(x0 + (b - y0) * slope);
      this.addRow(row, Math.min(xa, xb), Math.max(xa, xb), sign * (b - a), area);
      this.bottom = Math.max(this.bottom, row);
    }
  }
  // What is right of the edge, `height` of a row, counts.
  addRow(row, left, right, height, area) {
    const first = Math.floor(left), end = Math.ceil(right), start = row * this.stride;
    const double = 2 * (right - left), middle = 0.5 * (left + right);
    let before = 0, covered = 0; // area of the last column, and of all so far
    for (let column = first; column < end; ++column) {
      const x = column + 1;
      const all = height * (x >= right ? x - middle : (x - left) ** 2 / double);
      area[start + column] += all - covered - before;
      before = all - covered;
      covered = all;
    }
    area[start + end] += height - before;
    if (first < this.from[row]) this.from[row] = first;
    if (end > this.to[row]) this.to[row] = end;
  }
  blend(stroke, fill) {
    const {image: {data, width}, outer, inner, stride} = this;
    for (let row = this.top; row <= this.bottom; ++row) {
      let outside = 0, inside = 0;
      const end = this.to[row];
      for (let column = this.from[row]; column <= end; ++column) {
        const at = row * stride + column;
        outside += outer[at];
        inside += inner[at];
        outer[at] = inner[at] = 0;
        if (column >= width) continue;
        const covered = Math.min(Math.abs(outside), 1), f = Math.min(Math.abs(inside), covered), s = covered - f;
        if (covered > 1e-5) {
          const pixel = 4 * (row * width + column), rest = 1 - s * stroke[3] - f * fill[3];
          for (let k = 0; k < 3; ++k) data[pixel + k] = s * stroke[k] + f * fill[k] + rest * data[pixel + k];
        }
      }
      this.from[row] = width + 1;
      this.to[row] = -1;
    }
  }
  letter(letter, x, y, color) {
    const ink = this.colorOf(color), {image: {data, width, height}} = this;
    letter.cover ??= this.coverOf(letter);
    const {side, alpha} = letter.cover;
    for (let i = 0; i < alpha.length; ++i) {
      const column = x - kTextLine + i % side, row = y - kTextLine + Math.floor(i / side);
      if (alpha[i] === 0 || column < 0 || row < 0 || column >= width || row >= height) continue;
      const share = alpha[i] / 255, pixel = 4 * (row * width + column), rest = 1 - share * ink[3];
      for (let k = 0; k < 3; ++k) data[pixel + k] = share * ink[k] + rest * data[pixel + k];
    }
  }
  // How much of each pixel around a letter is covered: drawn large, and halved five times.
  coverOf({sign}) {
    const {ratio} = this.look, side = Math.ceil(3 * kTextLine * ratio);
    let last = null;
    const finest = kLetterScale / 2 ** Math.max(Math.floor(Math.log2(ratio)), 0);
    for (let scale = finest; scale >= 1; scale /= 2) {
      const canvas = Object.assign(document.createElement("canvas"), {width: scale * side, height: scale * side});
      const pen = canvas.getContext("2d");
      if (last) {
        pen.drawImage(last, 0, 0, scale * side, scale * side);
      } else {
        pen.font = `${scale * kTextSize * ratio}px ${kFontFamily}`;
        pen.fillText(sign, scale * kTextLine, scale * (kTextLine + Math.round(kTextAscent * ratio)));
      }
      last = canvas;
    }
    const {data} = last.getContext("2d").getImageData(0, 0, side, side);
    return {side, alpha: Uint8Array.from({length: side * side}, (_, i) => data[4 * i + 3])};
  }
}

function polygonOf({x, y, radius}) {
  const count = Math.max(Math.ceil(Math.PI / Math.acos(Math.max(1 - kSag / radius, 0.9))), 24);
  const points = new Float64Array(2 * count);
  for (let i = 0; i < count; ++i) {
    const angle = 2 * Math.PI * i / count;
    points[2 * i] = x + radius * Math.cos(angle);
    points[2 * i + 1] = y + radius * Math.sin(angle);
  }
  return points;
}
