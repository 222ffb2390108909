// The page: buttons, keys, mouse and fingers become a frame and a view, which are drawn.

const kSpeeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8];
const kZoomStep = 1.25;
const kPanStep = 0.1;   // of the height
const kLinkDelay = 200; // [ms]
const kRest = 120;      // until a picture is drawn exactly [ms]
const kExactPixels = 6e6; // larger pictures would block the page for more than 200 ms
const kContactReach = 24, kBodyReach = 4, kClickReach = 3; // [CSS px]

const kIsFramed = parent !== window;

const $ = id => document.getElementById(id);

class Player {
  constructor(film) {
    this.film = film;
    this.view = new View(film);
    this.painter = new Painter(film);
    this.exactPainter = new ExactPainter(film);
    this.canvas = $("picture");
    this.hidden = new Set(film.layers.filter(layer => !layer.isOn).map(layer => layer.number));
    this.theme = 0;       // index into film.themes
    this.number = 0;      // of the frame that is shown
    this.place = 0;       // while it plays, between frames
    this.speed = 1;
    this.isPlaying = false;
    this.lastTick = null; // [ms]
    this.frame = null;    // that was drawn last
    this.pointer = null;  // [CSS px]; null: not over the picture
    this.isAsked = false; // to draw
    this.fingers = new Map(); // places of those that are down [CSS px]
    this.linkedAt = -Infinity; // when the address was set [ms]
    this.linkTimer = null; // for the next one
    this.turn = 0;        // when the player was touched that leads those side by side [ms]
    this.leads = false;   // players beside this one show what it shows
    this.isLed = false;   // by one of them
    this.build();
    this.listen();
    this.resize();
  }

  // ------------------------------------------------------------------------------------- what is shown
  build() {
    $("time").max = this.film.frames - 1;
    for (const speed of kSpeeds) $("speed").append(new Option(`${speed}×`, speed, speed === 1, speed === 1));
    for (const layer of this.film.layers.filter(known => known.isThere)) {
      const box = document.createElement("input");
      box.type = "checkbox";
      box.value = layer.number;
      box.checked = layer.isOn;
      box.addEventListener("change", () => {
        box.checked ? this.hidden.delete(layer.number) : this.hidden.add(layer.number);
        this.redraw();
      });
      const label = document.createElement("label");
      label.append(box, layer.label);
      $("layers").lastElementChild.append(label);
    }
    $("link").hidden = kIsFramed; // it has no address
    this.setTheme(0);
  }
  // Pixels of the canvas for one of CSS.
  get ratio() {
    return window.devicePixelRatio || 1;
  }
  resize() {
    const box = this.canvas.getBoundingClientRect();
    const width = Math.max(Math.round(box.width * this.ratio), 1);
    const height = Math.max(Math.round(box.height * this.ratio), 1);
    if (width !== this.canvas.width || height !== this.canvas.height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.view.resize(width, height);
    if (this.frame) this.draw(); // a canvas of another size is empty
    else this.redraw();
  }
  // Soon, once for all that changes until then.
  redraw() {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(now => {
      this.isAsked = false;
      this.tick(now);
      this.draw();
      if (this.isPlaying && !this.isLed) this.redraw();
    });
  }
  tick(now) {
    if (!this.isPlaying || this.isLed) return;
    const passed = this.lastTick === null ? 0 : Math.min(now - this.lastTick, 250);
    this.lastTick = now;
    this.place += passed / 1000 * this.film.framesPerSecond * this.speed;
    if (this.place >= this.film.frames - 1) {
      if ($("repeat").checked) this.place = 0;
      else this.pause(this.film.frames - 1);
    }
    this.number = Math.min(Math.floor(this.place), this.film.frames - 1);
  }
  draw() {
    const frame = this.film.frame(this.number, () => this.redraw());
    this.showClock();
    if (!frame) return; // it is being unpacked
    if (frame !== this.frame) {
      this.frame = frame;
      if (!this.isLed) this.view.track(frame);
    }
    this.showFollowed();
    const look = {view: this.view.of(frame), ratio: this.ratio, theme: this.film.themes[this.theme], hidden: this.hidden};
    this.paint(frame, look);
    this.showBody(look.view);
    if (this.leads) this.lead();
  }
  // Quickly where it changes; exactly once it rests, which takes longer.
  paint(frame, look) {
    const {x, y, scale} = look.view;
    const picture = [this.number, x, y, scale, look.ratio, this.theme, ...this.hidden, "size", this.canvas.width, this.canvas.height, this.isPlaying].join();
    if (picture === this.painted) return;
    this.painted = picture;
    clearTimeout(this.exactTimer);
    this.painter.draw(this.canvas, frame, look);
    if (this.isPlaying || this.canvas.width * this.canvas.height > kExactPixels) return;
    this.exactTimer = setTimeout(() => this.exactPainter.draw(this.canvas, frame, look), kRest);
  }
  showFollowed() {
    const body = this.view.followed;
    const name = `body ${body} ${this.film.names[body] ?? ""}`.trim();
    const isThere = body >= 0 && describeBody(this.film, this.frame, body) !== null;
    $("follow").textContent = body < 0 ? "" : isThere ? `following ${name}` : `${name} is not in this frame`;
  }
  showClock() {
    const seconds = this.film.secondsOf(this.number);
    $("time").value = this.number;
    $("time").setAttribute("aria-valuetext", `${seconds.toFixed(3)} seconds`);
    $("clock").textContent = `${seconds.toFixed(3)} s · frame ${this.number} of ${this.film.frames - 1}`;
  }
  // Of several players side by side, the one touched last leads. It goes on from what they show.
  take() {
    // Clocks may go back; two fingers may come down at once.
    this.turn = Math.max(Date.now(), this.turn + 1) + Math.random();
    this.leads = true;
    if (this.isLed) {
      this.isLed = false;
      this.lastTick = null;
      const frame = this.film.frame(this.number, () => this.redraw());
      if (frame) {
        this.frame = frame; // it need not be drawn yet
        this.view.track(frame);
      }
    }
    this.redraw();
  }
  // A page that has several players passes the message on to the others.
  lead() {
    const {turn, number, isPlaying, speed, theme} = this, {own, followed} = this.view;
    const repeat = $("repeat").checked;
    parent.postMessage({turn, number, isPlaying, speed, repeat, own, followed, theme, hidden: [...this.hidden]}, "*");
  }
  // Shows what the player that leads shows. Messages cross: one of a player that leads no more is
  // answered, so that it learns so. Pages of older programs send no turn, and less.
  match({turn = this.turn + 1, number, isPlaying = false, speed = this.speed, repeat = $("repeat").checked, own,
         followed = -1, theme, hidden}) {
    if (turn < this.turn || (turn === this.turn && !this.isLed)) {
      if (this.leads) this.lead();
      return;
    }
    this.turn = turn;
    this.leads = false;
    this.isLed = true;
    this.isPlaying = isPlaying;
    this.showPlaying();
    this.setSpeed(speed);
    $("repeat").checked = repeat;
    this.view.follow(followed);
    this.view.own = own;
    this.hidden = new Set(hidden);
    for (const box of $("layers").querySelectorAll("input")) box.checked = !this.hidden.has(Number(box.value));
    if (theme !== this.theme) this.setTheme(theme);
    this.show(number);
  }
  bodyAtPointer(view) {
    if (!this.pointer || this.fingers.size > 0) return -1;
    const [x, y] = this.view.toWorld(view, ...this.inCanvas(this.pointer));
    return bodyAt(this.film, this.frame, x, y, kBodyReach * this.ratio / view.scale, this.hidden);
  }
  // Beside the pointer, or in the corner if that is elsewhere: number, name, place and velocity.
  showBody(view) {
    const number = this.pointer ? this.bodyAtPointer(view) : this.view.followed;
    const before = number < 0 || this.number === 0 ? null : this.film.frame(this.number - 1, () => this.redraw());
    const isWaiting = number >= 0 && this.number > 0 && !before; // for the frame before
    const body = number < 0 || isWaiting ? null : describeBody(this.film, this.frame, number, before);
    const card = $("body");
    card.hidden = !body;
    if (!body) return;
    const title = document.createElement("b");
    title.textContent = `body ${body.number} ${body.name}`.trim();
    card.replaceChildren(title, this.bodyText(body));
    const [x, y] = this.pointer ?? [0, 0];
    const box = this.canvas.getBoundingClientRect();
    card.style.left = `${Math.max(Math.min(x + 16, box.width - card.offsetWidth - 8), 0)}px`;
    card.style.top = `${Math.max(Math.min(y + 16, box.height - card.offsetHeight - 8), 0)}px`;
  }
  bodyText(body) {
    const text = value => value.toFixed(3).padStart(9);
    const lines = [`\nposition ${text(body.x)} ${text(body.y)} m`];
    if (body.hasAngle) lines.push(`angle    ${text(body.angle)} rad`);
    const speed = value => (Object.is(Number(value.toFixed(2)), -0) ? 0 : value).toFixed(2).padStart(9); // as exact as they are
    if (body.vx !== undefined) lines.push(`velocity ${speed(body.vx)} ${speed(body.vy)} m/s`, `spin     ${speed(body.spin)} rad/s`);
    return lines.join("\n");
  }
  setTheme(index) {
    this.theme = index;
    const {dark} = this.film.themes[index];
    document.documentElement.classList.toggle("light", !dark);
    $("theme").textContent = dark ? "Light" : "Dark"; // what a click makes of it
    this.redraw();
  }

  // ---------------------------------------------------------------------------------------------- time
  show(number) {
    this.number = Math.min(Math.max(number, 0), this.film.frames - 1);
    this.place = this.number;
    this.redraw();
  }
  play() {
    if (this.number >= this.film.frames - 1) this.show(0);
    this.isPlaying = true;
    this.lastTick = null;
    this.place = this.number;
    this.showPlaying();
    this.redraw();
  }
  pause(number = this.number) {
    this.isPlaying = false;
    this.showPlaying();
    this.show(number);
    this.keepLink();
  }
  showPlaying() {
    $("play").textContent = this.isPlaying ? "❚❚" : "▶";
    $("play").setAttribute("aria-label", this.isPlaying ? "Pause" : "Play");
  }
  step(frames) {
    this.pause(this.number + frames);
  }
  setSpeed(speed) {
    this.speed = speed;
    $("speed").value = speed;
    this.redraw();
  }
  changeSpeed(by) {
    const at = kSpeeds.indexOf(this.speed) + by;
    this.setSpeed(kSpeeds[Math.min(Math.max(at, 0), kSpeeds.length - 1)]);
  }

  // ---------------------------------------------------------------------------------------------- view
  zoom(factor, x = 0.5 * this.canvas.width, y = 0.5 * this.canvas.height) {
    if (!this.frame) return;
    this.view.zoom(this.frame, factor, x, y);
    this.keepLink();
    this.redraw();
  }
  resetView() {
    this.follow(-1);
    this.view.reset();
    this.keepLink();
    this.redraw();
  }
  follow(body) {
    this.view.follow(body);
    if (body >= 0 && this.frame) this.view.track(this.frame);
    this.keepLink();
    this.redraw();
  }
  // The next body that is in the frame, or none after the last.
  followNext(by) {
    if (!this.frame) return;
    const bodies = bodiesOf(this.film, this.frame);
    const at = bodies.indexOf(this.view.followed) + by;
    this.follow(bodies[by < 0 && this.view.followed < 0 ? bodies.length - 1 : at] ?? -1);
  }
  pan(dx, dy) {
    if (!this.frame) return;
    this.view.pan(this.frame, kPanStep * dx * this.canvas.height, kPanStep * dy * this.canvas.height);
    this.keepLink();
    this.redraw();
  }
  followPointed() {
    if (!this.frame) return;
    const body = this.bodyAtPointer(this.view.of(this.frame));
    this.follow(body === this.view.followed ? -1 : body);
  }
  // The contact next to a place of the canvas [px]; `far`: wherever it is in the picture.
  zoomToContact(x, y, far = false) {
    if (!this.frame) return;
    const view = this.view.of(this.frame);
    const [worldX, worldY] = this.view.toWorld(view, x, y);
    const reach = (far ? 0.5 * this.canvas.height : kContactReach * this.ratio) / view.scale;
    const stored = this.hidden.has(kContacts) ? null : contactAt(this.film, this.frame, worldX, worldY, reach);
    const contact = stored ?? touchAt(this.film, this.frame, worldX, worldY, reach);
    const [middleX, middleY] = contact ?? [worldX, worldY];
    this.view.choose({x: middleX, y: middleY, scale: this.view.limited(4 * view.scale)});
    this.keepLink();
    this.redraw();
  }

  // ---------------------------------------------------------------------------------------------- link
  // "#t=3.2s&at=0,5,20&follow=17": the time, the middle and the height of the view [m], a body.
  link() {
    const parts = [`t=${Number(this.film.secondsOf(this.number).toFixed(6))}s`];
    if (this.view.own) {
      const {x, y, height} = this.view.own;
      parts.push(`at=${[x, y, height].map(value => Number(value.toPrecision(9))).join(",")}`);
    }
    if (this.view.followed >= 0) parts.push(`follow=${this.view.followed}`);
    return `#${parts.join("&")}`;
  }
  // The address of the page is that of the moment, unless it plays. Browsers take few changes a second.
  keepLink() {
    clearTimeout(this.linkTimer);
    if (this.isPlaying || kIsFramed) return;
    const wait = this.linkedAt + kLinkDelay - performance.now();
    if (wait > 0) {
      this.linkTimer = setTimeout(() => this.keepLink(), wait);
      return;
    }
    this.linkedAt = performance.now();
    this.ownLink = this.link();
    history.replaceState(null, "", this.ownLink);
  }
  openLink() {
    if (location.hash === this.ownLink) return;
    clearTimeout(this.linkTimer); // of a moment before this one
    const asked = new URLSearchParams(location.hash.slice(1));
    const time = Number.parseFloat(asked.get("t")) * (/ms$/.test(asked.get("t") ?? "") ? 0.001 : 1);
    const at = (asked.get("at") ?? "").split(",").map(Number);
    const body = Number.parseInt(asked.get("follow"), 10);
    this.view.reset();
    if (at.length === 3 && at.every(Number.isFinite) && at[2] > 0) {
      this.view.choose({x: at[0], y: at[1], scale: this.view.limited(this.view.height / at[2])});
    }
    this.view.follow(Number.isNaN(body) ? -1 : body);
    this.frame = null; // the view is that of the frame asked for, which is drawn next
    this.pause(Number.isFinite(time) ? this.film.frameAt(time) : this.number);
  }
  async copyLink() {
    const text = location.href.split("#")[0] + this.link();
    try {
      await navigator.clipboard.writeText(text);
      tell("The link is copied.");
    } catch {
      tell(text); // a browser that keeps the clipboard to itself
    }
  }

  // --------------------------------------------------------------------------------------------- hands
  listen() {
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    if (kIsFramed) this.listenToOthers();
    addEventListener("hashchange", () => this.openLink());
    $("time").addEventListener("input", () => this.pause(Number($("time").value)));
    $("speed").addEventListener("change", () => this.setSpeed(Number($("speed").value)));
    $("repeat").addEventListener("change", () => this.redraw());
    const onClick = {
      play: () => this.toggle(), back: () => this.step(-1), forward: () => this.step(1),
      closer: () => this.zoom(kZoomStep), farther: () => this.zoom(1 / kZoomStep), reset: () => this.resetView(),
      theme: () => this.setTheme(1 - this.theme), link: () => this.copyLink(), help: () => $("keys").showModal(),
    };
    for (const [id, act] of Object.entries(onClick)) $(id).addEventListener("click", act);
    addEventListener("keydown", event => this.onKey(event));
    this.canvas.addEventListener("wheel", event => this.onWheel(event), {passive: false});
    this.canvas.addEventListener("pointerdown", event => this.onDown(event));
    this.canvas.addEventListener("pointermove", event => this.onMove(event));
    for (const name of ["pointerup", "pointercancel"]) {
      this.canvas.addEventListener(name, event => this.onUp(event, name === "pointerup"));
    }
    this.canvas.addEventListener("pointerleave", event => {
      if (event.pointerType === "touch") return; // what was tapped stays described
      this.pointer = null;
      this.redraw();
    });
    addEventListener("pointerdown", event => {
      if (!$("layers").contains(event.target)) $("layers").open = false;
    });
    this.canvas.addEventListener("dblclick", event => this.zoomToContact(...this.inCanvas(this.placeOf(event))));
  }
  listenToOthers() {
    for (const name of ["pointerdown", "pointermove", "wheel", "keydown", "input", "change", "click"]) {
      addEventListener(name, event => {
        if (name !== "pointermove" || event.buttons > 0) this.take();
      }, {capture: true, passive: true});
    }
    addEventListener("message", event => {
      if (event.source === parent) this.match(event.data);
    });
    this.lead(); // one that was touched before answers
  }
  toggle() {
    this.isPlaying ? this.pause() : this.play();
  }
  onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || $("keys").open) return;
    const isPressed = ["BUTTON", "SUMMARY"].includes(event.target.tagName) || event.target.type === "checkbox";
    const isChosen = event.target.tagName === "SELECT";
    if ((isPressed || isChosen) && [" ", "Enter"].includes(event.key)) return;
    if (isChosen && ["ArrowLeft", "ArrowRight", "Home", "End"].includes(event.key)) return;
    const second = Math.max(Math.round(this.film.framesPerSecond / this.film.speed), 1);
    const onKeys = {
      " ": () => this.toggle(),
      ArrowLeft: () => this.step(event.shiftKey ? -second : -1),
      ArrowRight: () => this.step(event.shiftKey ? second : 1),
      Home: () => this.pause(0), End: () => this.pause(this.film.frames - 1),
      "[": () => this.changeSpeed(-1), "]": () => this.changeSpeed(1),
      "+": () => this.zoom(kZoomStep), "=": () => this.zoom(kZoomStep), "-": () => this.zoom(1 / kZoomStep),
      0: () => this.resetView(), f: () => this.followPointed(), n: () => this.followNext(1), N: () => this.followNext(-1),
      4: () => this.pan(1, 0), 6: () => this.pan(-1, 0), 8: () => this.pan(0, 1), 2: () => this.pan(0, -1),
      z: () => this.zoomToContact(0.5 * this.canvas.width, 0.5 * this.canvas.height, true), d: () => this.setTheme(1 - this.theme),
      l: () => $("layers").toggleAttribute("open"), r: () => $("repeat").click(), c: () => this.copyLink(),
      "?": () => $("keys").showModal(), Escape: () => $("layers").open = false,
    };
    const act = onKeys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }
  // In the picture [CSS px].
  placeOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
  inCanvas([x, y]) {
    return [x * this.ratio, y * this.ratio];
  }
  onWheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 33 : 1; // Firefox counts lines
    this.zoom(Math.exp(-0.0015 * lines * event.deltaY), ...this.inCanvas(this.placeOf(event)));
    this.keepLink();
  }
  onDown(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, this.placeOf(event));
    this.pointer = this.placeOf(event);
    this.isClick = this.fingers.size === 1;
    this.downAt = this.placeOf(event);
  }
  onMove(event) {
    const [x, y] = this.placeOf(event);
    this.pointer = [x, y];
    const before = this.fingers.get(event.pointerId);
    if (before && this.frame) {
      this.isClick &&= Math.hypot(x - this.downAt[0], y - this.downAt[1]) < kClickReach;
      const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
      const share = this.ratio / this.fingers.size;
      this.view.pan(this.frame, share * (x - before[0]), share * (y - before[1]));
      if (other) this.pinch(before, [x, y], other);
      this.fingers.set(event.pointerId, [x, y]);
    }
    this.redraw();
  }
  pinch(before, now, other) {
    const gap = (a, b) => Math.max(Math.hypot(a[0] - b[0], a[1] - b[1]), 1);
    const middle = [0.5 * (now[0] + other[0]), 0.5 * (now[1] + other[1])];
    this.zoom(gap(now, other) / gap(before, other), ...this.inCanvas(middle));
  }
  onUp(event, isClick) {
    this.fingers.delete(event.pointerId);
    if (isClick && this.isClick) this.followPointed();
    this.keepLink();
    this.redraw();
  }
}

function tell(text) {
  $("message").textContent = text;
  clearTimeout(tell.timer);
  tell.timer = setTimeout(() => $("message").textContent = "", 6000);
}

let player = null;

async function open() {
  try {
    const groups = [...document.querySelectorAll("script.frames")].map(element =>
      ({frames: Number(element.dataset.frames), base64: () => element.textContent}));
    const film = await Film.open(JSON.parse($("head").textContent), groups);
    await film.frameLater(0);
    player = new Player(film);
    film.damaged = (group, error) => {
      player.pause(Math.max(group.first - 1, 0));
      $("message").textContent = `This page is damaged from frame ${group.first} on (${error.message}).`;
    };
    player.openLink();
    $("message").textContent = "";
    return player;
  } catch (error) {
    $("message").textContent = `This page is damaged (${error.message}).`;
    throw error;
  }
}
