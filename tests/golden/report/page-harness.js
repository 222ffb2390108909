"use strict";
// Put behind the page by PageInBrowserTest.cpp: uses it as a reader does, and leaves a line a check in #results.
(async () => {
const lines = [];
const check = (what, isRight, was = "") => lines.push(`${isRight ? "ok" : "WRONG"} ${what} ${isRight ? "" : was}`.trim());
const wait = ms => new Promise(done => setTimeout(done, ms));
const all = selector => [...document.querySelectorAll(selector)];
const one = selector => document.querySelector(selector);
const shown = () => all("article.moment").filter(card => card.getClientRects().length > 0).map(card => card.id).join(" ");
const press = key => document.activeElement.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
const type = text => { one("#filter").value = text; one("#filter").dispatchEvent(new Event("input")); };
const tab = (card, label) => [...card.querySelectorAll(".tabs button")].find(button => button.textContent === label);
addEventListener("error", event => lines.push(`WRONG script error: ${event.message}`));
try {
  await wait(300); // the window has seen what is in it
  const [gone, moved, painted] = ["gone/1s", "moved/1s", "painted/1s"].map(id => document.getElementById(id));
  check("cards in order of their names", shown() === "gone/1s moved/1s painted/1s", shown());
  check("nothing is loaded from elsewhere", performance.getEntriesByType("resource").every(e => e.name.startsWith("data:")));

  type("mov");
  check("the filter hides other names", shown() === "moved/1s", shown());
  check("it says how many are left", one("#shown").textContent === "1 of 3 shown", one("#shown").textContent);
  check("and how many of those that passed", one("#passed summary").textContent === "0 of 1 moment as approved", one("#passed summary").textContent);
  type("");
  check("or all of them", one("#passed summary").textContent === "1 moment as approved");
  one("#statuses button[data-status=drawlist]").click();
  check("a verdict's button hides its cards", shown() === "gone/1s moved/1s", shown());
  one("#statuses button[data-status=drawlist]").click();
  check("and shows them again", shown() === "gone/1s moved/1s painted/1s", shown());

  check("three pictures at first", moved.querySelectorAll(".view img").length === 3);
  await wait(100);
  check("they are decoded", [...moved.querySelectorAll(".view img")].every(image => image.naturalWidth === 320));
  check("what has no reference shows what there is", gone.querySelectorAll(".view img").length === 1 && !tab(gone, "Slider"));

  tab(moved, "Slider").click();
  await wait(100);
  const range = moved.querySelector(".view input[type=range]"), cut = moved.querySelector(".view img.actual");
  const clip = () => getComputedStyle(cut).clipPath;
  check("the slider begins in the middle", clip().includes("50%"), clip());
  range.value = 20;
  range.dispatchEvent(new Event("input"));
  check("the slider cuts the actual picture", clip().includes("20%"), clip());
  check("it tells so to who cannot see it", range.getAttribute("aria-valuetext") === "20% expected");
  range.scrollIntoView({block: "center", behavior: "instant"});
  const box = range.getBoundingClientRect();
  check("a pointer on the pictures is on the slider", document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2) === range);
  range.dispatchEvent(new PointerEvent("pointermove", {buttons: 1, clientX: box.left + box.width * 0.75, clientY: box.top + 5}));
  check("and moves it where it is", Math.abs(range.value - 75) <= 0.5 && clip().includes("75%"), clip());

  moved.querySelector("h2 a").focus();
  press("k");
  press("k"); // there is none before the first
  check("k ends at the first", document.activeElement === gone, document.activeElement.id);
  press("j");
  press("j");
  press("j"); // nor behind the last
  check("j ends at the last", document.activeElement === painted, document.activeElement.id);
  press("k");
  check("k goes back", document.activeElement === moved, document.activeElement.id);
  press("b");
  const stack = moved.querySelector(".blink .stack");
  const seen = new Set();
  for (let i = 0; i < 30; ++i) { seen.add(getComputedStyle(stack.querySelector("img.actual")).visibility); await wait(60); }
  check("b blinks", seen.size === 2, [...seen].join());
  [...moved.querySelectorAll(".blink button")].find(button => button.textContent === "Pause").click();
  const held = new Set();
  for (let i = 0; i < 30; ++i) { held.add(stack.className); await wait(60); }
  check("Pause holds it", held.size === 1);

  press("o");
  await wait(50);
  const svg = moved.querySelector("svg.overlay");
  const path = side => svg.querySelector(`path.${side}`);
  check("the overlay has both worlds", path("expected").getAttribute("d").includes("L") && path("actual").getAttribute("d").includes("L"));
  check("and what they share", path("same").getTotalLength() > 1);
  const inks = ["same", "expected", "actual"].map(side => getComputedStyle(path(side)).stroke);
  check("in three colours", new Set(inks).size === 3, inks.join());
  check("one of them dashed", getComputedStyle(path("actual")).strokeDasharray !== "none");
  const whole = svg.getAttribute("viewBox");
  [...moved.querySelectorAll(".controls button")].find(button => button.textContent === "What differs").click();
  check("the overlay zooms to what differs", Number(svg.getAttribute("viewBox").split(" ")[2]) < Number(whole.split(" ")[2]) / 2);
  const bounds = path("actual").getBBox(), view = svg.viewBox.baseVal;
  check("which lies in it", bounds.x >= view.x && bounds.x + bounds.width <= view.x + view.width);

  tab(moved, "Draw list").click();
  const rows = [...moved.querySelectorAll(".lines div")].map(row => row.textContent);
  check("the draw list shows the line that differs, before and after", rows.length === 2 && rows[0] !== rows[1], rows.join("|"));
  check("and the numbers that do", moved.querySelectorAll(".lines mark").length === 8, moved.querySelector(".lines").innerHTML);
  tab(moved, "Bodies").click();
  const cells = [...moved.querySelectorAll(".view tbody tr")].map(row => row.textContent);
  check("the table has the body that is off", cells.length === 1 && cells[0].startsWith("10.03"), cells.join("|"));
  moved.querySelector(".view tbody button").click();
  check("and leads to it", moved.querySelector("svg.overlay") !== null);
  check("the first step is told", moved.querySelector(".divergence h3").textContent === "First divergence: step 7 of 60, body 1");
  check("with the steps around it", moved.querySelectorAll(".strip figure").length === 2);

  const captions = [...moved.querySelectorAll(".strip figcaption")].map(caption => caption.textContent);
  check("each with what is known of it", captions.join() === "step 6: same,step 7: first to differ", captions.join());
  tab(painted, "Draw list").click();
  const pairs = [...painted.querySelectorAll(".lines div")].map(row => row.className + row.querySelectorAll("mark").length);
  check("lines that went and came are pairs", pairs.join() === "e1,a1,a0", pairs.join());

  one("#view").value = "actual";
  one("#view").dispatchEvent(new Event("change"));
  check("a view is chosen for all", all(".view").every(view => view.dataset.view === "actual"));
  one("#size").value = "2";
  one("#size").dispatchEvent(new Event("change"));
  check("at twice its size", moved.querySelector(".view img").getBoundingClientRect().width >= 640);
  press("/");
  check("/ goes to the filter", document.activeElement === one("#filter"));
  check("a name is a text", all("b.planted").length === 0 && window.planted === undefined);
} catch (error) {
  lines.push(`WRONG ${error.stack}`);
}
const results = document.createElement("pre");
results.id = "results";
results.textContent = `\nBEGIN\n${lines.join("\n")}\nEND\n`;
document.body.append(results);
})();
