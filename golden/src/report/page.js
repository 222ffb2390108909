"use strict";
// The page of `boxreel golden report`. A card contains its pictures and texts as JSON, parsed when it is near the
// visible area, so that a page of hundreds opens fast.
(() => {
const $ = (selector, root = document) => root.querySelector(selector);
const $$ = (selector, root = document) => [...root.querySelectorAll(selector)];
const cards = $$("article.moment");
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

// Returns an element: `make("div", {class: "x"}, child, "text")`. Texts are never parsed as HTML.
function make(tag, attributes = {}, ...children) {
  const isSvg = ["svg", "path", "g"].includes(tag);
  const element = isSvg ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

// ------------------------------------------------------------------------------------------- draw lists

const kLine = /^(?:world|body (\d+)) (\S+) (\S+) (#[0-9a-f]+)((?: \([^)]*\))*)(?: (radius|axes|pixels) (\S+))?/;

// Returns the items of a draw list's text (debugdraw/DrawListText.h); other lines are skipped.
function parseList(text) {
  const items = [];
  for (const line of text.split("\n")) {
    const found = kLine.exec(line);
    if (!found) continue;
    const points = [...found[5].matchAll(/\(([^,]+), ([^)]+)\)/g)].map(p => [Number(p[1]), -Number(p[2])]);
    if (points.length === 0 || !points.flat().every(Number.isFinite)) continue;
    items.push({line, body: found[1] === undefined ? null : Number(found[1]), kind: found[3], points,
                size: Number(found[7] || 0)});
  }
  return items;
}

function outlineOf(item) {
  const [x, y] = item.points[0];
  if (item.kind.endsWith("circle")) {
    const r = item.size;
    let path = `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
    if (item.points[1]) path += `M${x} ${y}L${x + r * item.points[1][0]} ${y + r * item.points[1][1]}`;
    return path;
  }
  if (item.kind === "transform") {
    const [ax, ay] = item.points[1] || [1, 0];
    const s = item.size;
    return `M${x + s * ax} ${y + s * ay}L${x} ${y}L${x + s * ay} ${y - s * ax}`;
  }
  if (item.points.length === 1) return `M${x} ${y}h0`; // a point, or the position of a text
  return "M" + item.points.map(p => p.join(" ")).join("L") + (item.kind.endsWith("polygon") ? "Z" : "");
}

function boundsOf(items) {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const item of items) {
    const isRound = item.kind.endsWith("circle");
    const r = isRound || item.kind === "transform" ? item.size : 0;
    // The second point of these kinds is a direction.
    for (const [x, y] of isRound || item.kind === "transform" ? [item.points[0]] : item.points) {
      [x0, y0, x1, y1] = [Math.min(x0, x - r), Math.min(y0, y - r), Math.max(x1, x + r), Math.max(y1, y + r)];
    }
  }
  return x0 <= x1 ? {x: x0, y: y0, width: x1 - x0, height: y1 - y0} : null;
}

// Matches equal lines of both lists, each occurrence once.
function splitItems(expected, actual) {
  const count = new Map();
  for (const item of expected) count.set(item.line, (count.get(item.line) || 0) + 1);
  const same = [], added = [];
  for (const item of actual) {
    const left = count.get(item.line) || 0;
    (left > 0 ? same : added).push(item);
    if (left > 0) count.set(item.line, left - 1);
  }
  const gone = expected.filter(item => {
    const left = count.get(item.line) || 0;
    if (left > 0) count.set(item.line, left - 1);
    return left > 0;
  });
  return {same, gone, added};
}

// ------------------------------------------------------------------------------------------- texts

// Returns the different lines, as [number, expected or null, number, actual or null], in order. Removed and added
// lines are paired, because draw lists mostly keep their items and change numbers.
function differentLines(before, after) {
  const a = before.replace(/\n$/, "").split("\n"), b = after.replace(/\n$/, "").split("\n");
  let begin = 0, endA = a.length, endB = b.length;
  while (begin < Math.min(endA, endB) && a[begin] === b[begin]) ++begin;
  while (endA > begin && endB > begin && a[endA - 1] === b[endB - 1]) --endA, --endB;
  const n = endA - begin, m = endB - begin;
  const rows = [];
  if (n * m > 4e6) { // too many for a table of all pairs
    for (let i = begin; i < Math.max(endA, endB); ++i) {
      rows.push([i + 1, i < endA ? a[i] : null, i + 1, i < endB ? b[i] : null]);
    }
    return rows.filter(row => row[1] !== row[3]);
  }
  // The longest common subsequence.
  const length = new Uint32Array((n + 1) * (m + 1));
  for (let i = n - 1; i >= 0; --i) {
    for (let j = m - 1; j >= 0; --j) {
      length[i * (m + 1) + j] = a[begin + i] === b[begin + j] ? length[(i + 1) * (m + 1) + j + 1] + 1
        : Math.max(length[(i + 1) * (m + 1) + j], length[i * (m + 1) + j + 1]);
    }
  }
  for (let i = 0, j = 0; i < n || j < m;) {
    if (i < n && j < m && a[begin + i] === b[begin + j]) { ++i; ++j; continue; }
    const goesDown = j === m || (i < n && length[(i + 1) * (m + 1) + j] >= length[i * (m + 1) + j + 1]);
    if (goesDown) { rows.push([begin + i + 1, a[begin + i], 0, null]); ++i; }
    else { rows.push([0, null, begin + j + 1, b[begin + j]]); ++j; }
  }
  return paired(rows);
}

// Pairs lines that were removed and added at the same place.
function paired(rows) {
  const pairs = [];
  for (let i = 0; i < rows.length;) {
    const gone = [], come = [];
    while (i < rows.length && rows[i][1] !== null && (gone.length === 0 || rows[i][0] === gone.at(-1)[0] + 1)) gone.push(rows[i++]);
    while (i < rows.length && rows[i][3] !== null && (come.length === 0 || rows[i][2] === come.at(-1)[2] + 1)) come.push(rows[i++]);
    for (let k = 0; k < Math.max(gone.length, come.length); ++k) {
      pairs.push([...(gone[k] || [0, null]).slice(0, 2), ...(come[k] || [0, null, 0, null]).slice(2)]);
    }
  }
  return pairs;
}

// Returns a line in which words that differ from the other line are marked.
function markedLine(side, number, line, other) {
  const row = make("div", {class: side}, make("i", {}, String(number).padStart(4) + " "));
  const words = line.split(/( )/), others = other === null ? null : other.split(/( )/);
  words.forEach((word, i) => row.append(others && word !== others[i] ? make("mark", {}, word) : word));
  return row;
}

function parseState(text) {
  const bodies = new Map();
  for (const line of text.split("\n").slice(1)) {
    const [number, ...values] = line.split(" ").map(Number);
    if (values.length >= 3) bodies.set(number, values);
  }
  return bodies;
}

// Returns the bodies that differ, largest difference first.
function differentBodies(before, after) {
  const rows = [];
  for (const number of new Set([...before.keys(), ...after.keys()])) {
    const a = before.get(number), b = after.get(number);
    if (!a || !b) { rows.push({number, note: a ? "gone" : "new", far: Infinity}); continue; }
    if (String(a) === String(b)) continue;
    const [dx, dy, turn] = [b[0] - a[0], b[1] - a[1], (b[2] - a[2]) * 180 / Math.PI];
    const speed = Math.hypot((b[3] || 0) - (a[3] || 0), (b[4] || 0) - (a[4] || 0));
    rows.push({number, dx, dy, turn, speed, far: Math.hypot(dx, dy)});
  }
  return rows.sort((p, q) => q.far - p.far || p.number - q.number);
}

// ------------------------------------------------------------------------------------------- views

function picture(data, side, caption) {
  const source = data[side + "Picture"];
  if (!source) return make("p", {class: "message"}, `There is no ${side} picture.`);
  const image = make("img", {src: source, alt: `${caption}: ${data.verdict.name}`, class: side, decoding: "async"});
  sizeLater(image);
  return image;
}

const sizeOf = () => $("#size").value;
function sizeNow(image) {
  image.closest(".three")?.classList.toggle("wide", isWide(image));
  const times = sizeOf();
  image.style.width = times === "fit" ? "" : `${image.naturalWidth * Number(times)}px`;
}
function sizeLater(image) {
  if (image.complete) sizeNow(image); else image.addEventListener("load", () => sizeNow(image));
}

const figure = (data, side, caption = side) =>
  make("figure", {}, make("figcaption", {class: side}, caption), picture(data, side, caption));

// True for wide pictures such as contact sheets, which would be too small side by side.
function isWide(image) { return image.naturalWidth > 2.5 * image.naturalHeight; }

const viewThree = (data) => make("div", {class: "three"},
  ...["expected", "actual", "difference"].filter(side => data[side + "Picture"]).map(side => figure(data, side)));

function stackOf(data) {
  return make("div", {class: "stack"}, picture(data, "expected", "expected"), picture(data, "actual", "actual"));
}

function viewSlider(data) {
  const stack = stackOf(data);
  $("img.actual", stack).classList.add("cut");
  const range = make("input", {type: "range", min: 0, max: 100, step: 0.5, value: 50,
                               "aria-label": "Expected to the left of this line, actual to the right"});
  const move = () => {
    stack.style.setProperty("--at", `${range.value}%`);
    range.setAttribute("aria-valuetext", `${range.value}% expected`);
  };
  range.addEventListener("input", move);
  stack.append(make("div", {class: "handle"}), range);
  move();
  // A slider's thumb stops half its width from the ends; the line follows the pointer.
  range.addEventListener("pointermove", event => {
    if (event.buttons & 1) {
      const box = stack.getBoundingClientRect();
      range.value = (event.clientX - box.left) / box.width * 100;
      move();
    }
  });
  return make("div", {class: "pane"},
    make("div", {class: "controls"}, make("span", {class: "e"}, "\u25c0 expected"), make("span", {class: "a"}, "actual \u25b6"),
      make("span", {class: "message"}, "Drag, or use the arrow keys.")), stack);
}

function viewBlink(data) {
  const stack = stackOf(data);
  const which = make("b", {class: "e", role: "status"}, "expected");
  const speed = make("input", {type: "range", min: 1, max: 6, step: 0.5, value: blinkRate, "aria-label": "Changes a second"});
  const play = make("button", {type: "button"});
  const rate = make("span", {});
  let timer = null;
  const flip = () => {
    const isActual = stack.classList.toggle("other-side");
    which.textContent = isActual ? "actual" : "expected";
    which.className = isActual ? "a" : "e";
  };
  const run = (isOn) => {
    clearInterval(timer);
    // Stops when the view has been replaced.
    timer = isOn ? setInterval(() => stack.isConnected ? flip() : run(false), 1000 / blinkRate) : null;
    play.textContent = isOn ? "Pause" : "Play";
    which.setAttribute("aria-live", isOn ? "off" : "polite");
  };
  const tell = () => { rate.textContent = `${blinkRate} a second`; };
  play.addEventListener("click", () => run(timer === null));
  speed.addEventListener("input", () => {
    blinkRate = Number(speed.value); // at most 6: three flashes per second are safe (WCAG 2.3.1)
    tell();
    if (timer !== null) run(true);
  });
  tell();
  run(!reducedMotion.matches);
  reducedMotion.addEventListener("change", () => run(!reducedMotion.matches));
  const view = make("div", {class: "pane blink"}, make("div", {class: "controls"}, which, play,
    make("button", {type: "button", onclick: () => { run(false); flip(); }}, "Switch"), make("label", {}, "Speed ", speed), rate),
    stack);
  return view;
}
let blinkRate = 2;

function viewOverlay(data, card) {
  const {same, gone, added} = splitItems(parseList(data.expectedList || ""), parseList(data.actualList || ""));
  const all = [...same, ...gone, ...added];
  const svg = make("svg", {class: "overlay", tabindex: 0, role: "img",
    "aria-label": `Outlines of both worlds: ${gone.length} items only as expected, ${added.length} only as they are now`});
  for (const [side, items] of [["same", same], ["expected", gone], ["actual", added]]) {
    svg.append(make("path", {class: side, d: items.map(outlineOf).join("")}));
  }
  const whole = viewOfCamera(data.verdict.view) || padded(boundsOf(all), 16 / 9);
  const different = padded(boundsOf([...gone, ...added]), whole.width / whole.height);
  let box = {...whole};
  const wide = make("span", {});
  const show = (next) => {
    box = next;
    svg.setAttribute("viewBox", `${box.x} ${box.y} ${box.width} ${box.height}`);
    wide.textContent = `${Number(box.width.toPrecision(3))} m wide`;
  };
  const zoom = (times, cx = box.x + box.width / 2, cy = box.y + box.height / 2) => {
    show({x: cx - (cx - box.x) / times, y: cy - (cy - box.y) / times, width: box.width / times, height: box.height / times});
  };
  const pan = (dx, dy) => show({...box, x: box.x + dx * box.width, y: box.y + dy * box.height});
  const toBody = (number) => {
    const bounds = boundsOf(all.filter(item => item.body === number));
    if (bounds) show(padded(bounds, whole.width / whole.height, 0.6));
  };
  svg.setAttribute("preserveAspectRatio", "xMidYMid meet");
  svg.style.aspectRatio = `${whole.width} / ${whole.height}`;
  show(whole);
  let held = null;
  svg.addEventListener("pointerdown", event => { held = [event.clientX, event.clientY]; svg.setPointerCapture(event.pointerId); });
  svg.addEventListener("pointermove", event => {
    if (!held) return;
    const scale = box.width / svg.clientWidth;
    show({...box, x: box.x - (event.clientX - held[0]) * scale, y: box.y - (event.clientY - held[1]) * scale});
    held = [event.clientX, event.clientY];
  });
  for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => { held = null; });
  svg.addEventListener("wheel", event => { // the page scrolls unless Ctrl is held
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const place = svg.getBoundingClientRect();
    zoom(event.deltaY < 0 ? 1.25 : 0.8, box.x + (event.clientX - place.left) / place.width * box.width,
      box.y + (event.clientY - place.top) / place.height * box.height);
  }, {passive: false});
  svg.addEventListener("keydown", event => {
    const act = {"+": () => zoom(1.5), "-": () => zoom(1 / 1.5), ArrowLeft: () => pan(-0.1, 0), ArrowRight: () => pan(0.1, 0),
                 ArrowUp: () => pan(0, -0.1), ArrowDown: () => pan(0, 0.1)}[event.key];
    if (act) { act(); event.preventDefault(); }
  });
  const first = (data.verdict.firstBodies || []).find(number => all.some(item => item.body === number));
  const button = (text, act, isOff = false) => make("button", {type: "button", disabled: isOff, onclick: act}, text);
  if (card.body !== undefined) { toBody(card.body); card.body = undefined; }
  const sample = (side) => make("svg", {viewBox: "0 0 36 8", "aria-hidden": "true"}, make("path", {class: side, d: "M1 4H35"}));
  return make("div", {},
    make("div", {class: "controls"}, button("Whole picture", () => show(whole)), button("What differs", () => show(different), !different),
      ...(first === undefined ? [] : [button(`Body ${first}`, () => toBody(first))]),
      button("+", () => zoom(1.5)), button("\u2212", () => zoom(1 / 1.5)), wide, make("span", {class: "message"}, "Drag to move, Ctrl and wheel to zoom.")),
    svg,
    make("div", {class: "legend"}, make("span", {}, sample("expected"), ` expected (${gone.length})`),
      make("span", {}, sample("actual"), ` actual (${added.length})`), make("span", {}, sample("same"), ` the same in both (${same.length})`)));
}

function viewOfCamera(view) {
  if (!view) return null;
  const [width, height, x, y, scale] = view; // pixels, metres, pixels per metre
  return {x: x - width / scale / 2, y: -y - height / scale / 2, width: width / scale, height: height / scale};
}

// Returns the bounds with a `margin`, at least a centimetre wide, with the aspect ratio.
function padded(bounds, aspect, margin = 0.1) {
  if (!bounds) return null;
  const height = Math.max(bounds.height * (1 + 2 * margin), bounds.width * (1 + 2 * margin) / aspect, 0.01);
  const [cx, cy] = [bounds.x + bounds.width / 2, bounds.y + bounds.height / 2];
  return {x: cx - height * aspect / 2, y: cy - height / 2, width: height * aspect, height};
}

const kMostLines = 200;
function viewLines(data) {
  const rows = differentLines(data.expectedList, data.actualList);
  const box = make("div", {class: "lines", tabindex: 0, role: "region", "aria-label": "Lines of the draw list that differ"});
  for (const [n, before, m, after] of rows.slice(0, kMostLines)) {
    if (before !== null) box.append(markedLine("e", n, before, after));
    if (after !== null) box.append(markedLine("a", m, after, before));
  }
  const more = rows.length > kMostLines ? `, the first ${kMostLines} of them` : "";
  return make("div", {}, make("p", {class: "message"}, rows.length === 0 ? "The draw lists are the same."
    : `${rows.length} ${rows.length === 1 ? "line differs" : "lines differ"}${more}: what was expected, then what it is now.`),
    rows.length === 0 ? "" : box);
}

const kMostBodies = 25;
function viewBodies(data, card) {
  const rows = differentBodies(parseState(data.expectedState), parseState(data.actualState));
  if (rows.length === 0) return make("p", {class: "message"}, "All bodies stand and move the same at this moment.");
  const number = (value, digits = 3) => String(Number(value.toPrecision(digits)));
  const body = make("tbody");
  for (const row of rows.slice(0, kMostBodies)) {
    const go = make("button", {type: "button", disabled: !data.actualList || !data.expectedList, title: "Show it in the overlay",
      onclick: () => { card.body = row.number; choose(card, "overlay"); }}, String(row.number));
    body.append(make("tr", {}, make("th", {scope: "row"}, go), ...(row.note ? [make("td", {colspan: 5}, row.note)]
      : [row.far, row.dx, row.dy, row.turn, row.speed].map(value => make("td", {}, number(value))))));
  }
  return make("div", {class: "pane"}, make("p", {class: "message"}, `${rows.length} ${rows.length === 1 ? "body differs" : "bodies differ"}` +
    (rows.length > kMostBodies ? `, the ${kMostBodies} furthest off:` : ", the furthest off first:")),
    make("table", {}, make("thead", {}, make("tr", {}, ...["body", "off by [m]", "right [m]", "up [m]", "turned [\u00b0]",
      "velocity [m/s]"].map(text => make("th", {scope: "col"}, text)))), body));
}

// Two players of one scene: the one that was touched last leads, the other shows the same moment and view.
function viewPlay(data) {
  const {expectedPage, actualPage, width, height} = data.strip;
  const frames = [["expected", expectedPage], ["actual", actualPage]].map(([side, page]) =>
    make("iframe", {srcdoc: page, title: `${side}: ${data.verdict.name}`, class: side, style: `aspect-ratio:${width}/${height * 1.25}`}));
  const pass = event => {
    if (!frames[0].isConnected) { removeEventListener("message", pass); return; }
    const from = frames.findIndex(frame => frame.contentWindow === event.source);
    if (from >= 0) frames[1 - from].contentWindow.postMessage(event.data, "*");
  };
  addEventListener("message", pass);
  return make("div", {}, make("div", {class: "two"}, ...frames.map(frame => make("figure", {},
    make("figcaption", {class: frame.className}, frame.className === "expected" ? "expected: the other program" : "actual: this program"), frame))),
    make("p", {class: "message"}, "Both show the same moment and view; use the controls of either."));
}

const kViews = [
  {id: "three", label: "Side by side", key: "a", needs: d => d.actualPicture && d.expectedPicture, make: viewThree},
  {id: "expected", label: "Expected", needs: d => d.expectedPicture, make: d => figure(d, "expected")},
  {id: "actual", label: "Actual", needs: d => d.actualPicture, make: d => figure(d, "actual")},
  {id: "difference", label: "Difference", key: "d", needs: d => d.differencePicture, make: d => figure(d, "difference",
    "difference: red over the limits, blue within them")},
  {id: "blink", label: "Blink", key: "b", needs: d => d.expectedPicture && d.actualPicture, make: viewBlink},
  {id: "slider", label: "Slider", key: "s", needs: d => d.expectedPicture && d.actualPicture, make: viewSlider},
  {id: "overlay", label: "Overlay", key: "o", needs: d => d.expectedList && d.actualList, make: viewOverlay},
  {id: "play", label: "Play both", key: "p", needs: d => d.strip && d.strip.actualPage, make: viewPlay},
  {id: "lines", label: "Draw list", needs: d => d.expectedList && d.actualList, make: viewLines},
  {id: "bodies", label: "Bodies", needs: d => d.expectedState && d.actualState, make: viewBodies},
];

// ------------------------------------------------------------------------------------------- first divergence

function divergence(data) {
  const {firstStep, firstBodies = [], since, step, status} = data.verdict;
  const strip = data.strip;
  if (firstStep === undefined) {
    return status !== "state" ? "" : make("p", {class: "message"},
      "The steps on the way here were not kept, so nothing is known of when the worlds parted; Bodies says by how much each is off now.");
  }
  if (strip && strip.earlier) {
    return make("section", {class: "divergence"}, make("h3", {}, `First divergence: before this moment, at ${strip.note}: `,
      make("a", {href: `#${strip.earlier}`}, strip.earlier)));
  }
  const who = firstBodies.length === 0 ? "" : firstBodies.length === 1 ? `, body ${firstBodies[0]}`
    : `, bodies ${firstBodies.slice(0, 8).join(", ")}${firstBodies.length > 8 ? "\u2026" : ""}`;
  const isFirstKnown = firstStep === since && since > 1;
  const box = make("section", {class: "divergence"},
    make("h3", {}, `First divergence: step ${firstStep}${isFirstKnown ? " or before" : ""}${step === undefined ? "" : ` of ${step}`}${who}`));
  if (!strip) return box;
  if (strip.note) box.append(make("p", {class: "message"}, strip.note));
  // Steps before `since` were not compared.
  const comment = at => at === firstStep ? (isFirstKnown ? ": differs" : ": first to differ") : at > firstStep ? "" : at === 0 ? ": as created" : at >= since ? ": same" : "";
  const film = make("div", {class: "strip", tabindex: 0, role: "region", "aria-label": "Steps around the first divergence"});
  for (const shot of strip.pictures) {
    const rows = [["expected", shot.expected], ["actual", shot.actual], ["expected, close", shot.expectedCloseUp], ["actual, close", shot.closeUp]];
    film.append(make("figure", {class: shot.step === firstStep ? "first" : ""},
      make("figcaption", {}, `step ${shot.step}${comment(shot.step)}`),
      ...rows.filter(([, source]) => source).map(([row, source]) => {
        const frame = make("div", {class: "frame"}, make("img", {src: source, alt: `${row}, step ${shot.step}`, title: row,
          width: strip.width, height: strip.height, decoding: "async"}));
        if (!row.endsWith("close") && shot.mark.length === 4) {
          const [x, y, width, height] = shot.mark;
          const across = pixels => `${pixels / strip.width * 100}%`, down = pixels => `${pixels / strip.height * 100}%`;
          frame.append(make("i", {style: `left:${across(x)};top:${down(y)};width:${across(width)};height:${down(height)}`}));
        }
        return frame;
      })));
  }
  if (strip.pictures.length > 0) {
    const shot = strip.pictures[0];
    const rows = [shot.expected ? "The other program, this program" : "This program",
      !shot.closeUp ? "" : shot.expected ? "and both close to the first body, which is framed above" : "and close to the first body, which is framed above"];
    box.append(film, make("p", {class: "message"}, rows.filter(row => row).join(", ") + "."));
    if (shot.expected && !strip.actualPage) {
      box.append(make("p", {class: "message"}, "The other program writes no pages, so the worlds cannot be played side by side."));
    }
  }
  return box;
}

// ------------------------------------------------------------------------------------------- cards

function choose(card, id, isAsked = true) {
  open(card);
  const view = kViews.find(v => v.id === id && v.needs(card.data)) || kViews.find(v => v.needs(card.data));
  for (const button of $$(".tabs button", card)) button.setAttribute("aria-pressed", String(view && button.value === view.id));
  card.view = view ? view.id : null;
  if (isAsked) card.asked = true;
  $(".view", card).replaceChildren(view ? view.make(card.data, card) : "");
  $(".view", card).dataset.view = card.view || "";
}

function open(card) {
  if (card.data) return;
  card.data = JSON.parse($("script", card).textContent);
  const tabs = make("div", {class: "tabs", role: "group", "aria-label": "View"});
  for (const view of kViews.filter(v => v.needs(card.data))) {
    tabs.append(make("button", {type: "button", value: view.id, "aria-pressed": "false", title: view.key ? `key ${view.key}` : "",
      onclick: () => { current(card); choose(card, view.id); }}, view.label));
  }
  $(".views", card).append(divergence(card.data), tabs, make("div", {class: "view"}));
  choose(card, $("#view").value, false);
}

let currentCard = null;
function current(card) {
  if (currentCard) currentCard.classList.remove("current");
  currentCard = card;
  card.classList.add("current");
}

function go(direction) {
  const shown = cards.filter(card => !card.hidden);
  if (shown.length === 0) return;
  const at = shown.indexOf(currentCard);
  const next = shown[at < 0 ? 0 : Math.min(shown.length - 1, Math.max(0, at + direction))];
  current(next);
  open(next);
  next.focus({preventScroll: true});
  next.scrollIntoView({block: "start"});
}

// Returns the card for key presses: the one navigated to, otherwise the first visible one.
function target() {
  if (currentCard && !currentCard.hidden) return currentCard;
  const under = $("nav").getBoundingClientRect().bottom;
  const seen = cards.find(card => !card.hidden && card.getBoundingClientRect().bottom > under + 40);
  if (seen) current(seen);
  return seen;
}

// ------------------------------------------------------------------------------------------- filter

function filter() {
  const words = $("#filter").value.toLowerCase().split(/\s+/).filter(word => word);
  const on = new Set($$("#statuses button[aria-pressed=true]").map(button => button.dataset.status));
  const fits = name => words.every(word => name.includes(word));
  let number = 0;
  for (const card of cards) {
    card.hidden = !(on.has(card.dataset.status) && fits(card.dataset.name));
    number += card.hidden ? 0 : 1;
  }
  const passed = $("details#passed"); // a card may have the same id
  if (passed) {
    passed.hidden = !on.has(passed.dataset.status);
    const items = $$("li", passed);
    for (const item of items) item.hidden = !fits(item.dataset.name);
    const left = items.filter(item => !item.hidden).length;
    const all = `${items.length} ${items.length === 1 ? "moment" : "moments"} as approved`;
    $("summary", passed).textContent = left === items.length ? all : `${left} of ${all}`;
  }
  openSeen();
  $("#shown").textContent = cards.length === 0 ? "" : `${number} of ${cards.length} shown`;
}

$("#filter").addEventListener("input", filter);
for (const button of $$("#statuses button")) {
  button.addEventListener("click", () => {
    button.setAttribute("aria-pressed", String(button.getAttribute("aria-pressed") !== "true"));
    filter();
  });
}
for (const view of kViews) $("#view").append(make("option", {value: view.id}, view.label));
$("#view").addEventListener("change", () => {
  for (const card of cards.filter(c => c.data)) choose(card, $("#view").value, false);
});
$("#size").addEventListener("change", () => {
  document.body.classList.toggle("sized", sizeOf() !== "fit");
  $$(".view img").forEach(sizeNow);
});

document.addEventListener("keydown", event => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.target.matches("input[type=search], select")) {
    if (event.key === "Escape") event.target.blur();
    return;
  }
  if (event.key === "j" || event.key === "k") return go(event.key === "j" ? 1 : -1);
  if (event.key === "/") { $("#filter").focus(); event.preventDefault(); return; }
  const view = kViews.find(v => v.key === event.key), card = view && target();
  if (card) choose(card, view.id);
});

// Renders cards in and slightly below the visible area.
function openSeen() {
  for (const card of cards.filter(c => !c.hidden)) {
    const place = card.getBoundingClientRect();
    if (place.top > innerHeight + 400) break;
    if (place.bottom > 0) open(card);
  }
}
let isWaiting = false;
for (const event of ["scroll", "resize"]) {
  addEventListener(event, () => {
    if (!isWaiting) requestAnimationFrame(() => { isWaiting = false; openSeen(); });
    isWaiting = true;
  }, {passive: true});
}
addEventListener("beforeprint", () => cards.filter(card => !card.hidden).forEach(open));
if (cards.length === 0) { $("#filter").placeholder = "Filter names"; $$("#keys, nav label").forEach(e => { e.hidden = true; }); }
filter();
})();
