// SPDX-License-Identifier: MIT
// Pages of two worlds side by side, as reports have them, in Chromium.
#include "PageInBrowser.h"

#include <golden/ReportPage.h>

namespace boxreel
{
namespace
{

using testing::HasSubstr;
using testing::Not;

class TwoPages : public PageInBrowser
{
protected:
    /// Runs a script in a report of two worlds, whose windows are `left` and `right`.
    std::string RunBoth(const std::string& script)
    {
        FilmStrip strip;
        strip.width = 16;
        strip.height = 9;
        strip.expectedPage = PageOf("dominos", "shapes,joints,contacts", 120);
        const std::size_t head = strip.expectedPage.find("</head>");
        EXPECT_NE(head, std::string::npos);
        // Chromium hardly ever draws while its time is virtual, so frames come from a timer, and
        // the canvases keep their sizes: by chance, only one would learn of another.
        strip.expectedPage.insert(head, R"(<script>
window.requestAnimationFrame = draw => setTimeout(() => draw(performance.now()), 16);
window.ResizeObserver = class { observe() {} };
</script>)");
        strip.actualPage = strip.expectedPage;
        ReportedMoment moment;
        moment.shown.name = "dominos/2s";
        moment.shown.status = "pixels";
        moment.shown.json = R"({"name":"dominos/2s","status":"pixels"})";
        const Result<std::string> report = ReportPage({moment}, {{"dominos/2s", strip}});
        EXPECT_TRUE(report);
        return Run(*report, R"(
(async () => {
  const lines = [];
  const check = (what, is) => lines.push(`${is ? "right" : "WRONG"} ${what}`);
  const soon = () => new Promise(done => setTimeout(done, 300));
  document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "p", bubbles: true}));
  const windows = [...document.querySelectorAll("iframe")].map(frame => frame.contentWindow);
  check("two players", windows.length === 2);
  const ready = window => window.document.querySelector("#clock")?.textContent;
  for (let i = 0; i < 20 && !windows.every(ready); ++i) await soon();
  const [left, right] = windows;
  const find = (window, what) => window.document.querySelector(what);
  const picture = window => find(window, "canvas").toDataURL();
  const key = (window, name, more = {}) => window.dispatchEvent(new window.KeyboardEvent("keydown", {key: name, ...more}));
  const clocks = () => windows.map(window => find(window, "#clock").textContent).join(" and ");
)" + script + R"(
  leave(lines.join("\n"));
})().catch(error => leave(`WRONG ${error.stack}`));
)");
    }
};

TEST_F(TwoPages, ShowTheSameMomentAndView)
{
    const std::string results = RunBoth(R"(
  key(left, "ArrowRight", {shiftKey: true});
  await soon(); await soon();
  check(`the right one shows the moment of the left one: ${clocks()}`, /^1.000 s · frame 60.* and 1.000 s · frame 60/.test(clocks()));
  key(right, "ArrowRight");
  key(right, "+"); key(right, "+");
  await soon(); await soon();
  check(`the left one shows the moment of the right one: ${clocks()}`, / frame 61 .* frame 61 /.test(clocks()));
  check("both have the same view", picture(left) === picture(right));
  key(left, "+");
  await soon(); await soon();
  check("a zoom is passed on", picture(left) === picture(right));
  const box = left.document.querySelector("#layers input");
  box.dispatchEvent(new left.Event("pointerdown", {bubbles: true}));
  box.click();
  await soon(); await soon();
  check("a layer is passed on", !right.document.querySelector("#layers input").checked && picture(left) === picture(right));
)");
    EXPECT_THAT(results, Not(HasSubstr("WRONG")));
    EXPECT_THAT(results, HasSubstr("right a layer is passed on"));
}

// Messages of both are then on their way at once.
TEST_F(TwoPages, ShowTheOneTouchedLastWhileTheOtherPlays)
{
    const std::string results = RunBoth(R"(
  addEventListener("message", event => {
    const from = windows.indexOf(event.source), message = event.data;
    event.stopImmediatePropagation();
    setTimeout(() => windows[1 - from].postMessage(message, "*"), 40);
  }, true);
  const wait = time => new Promise(done => setTimeout(done, time));
  const state = window => [find(window, "#clock").textContent, find(window, "#play").textContent, find(window, "#speed").value,
    find(window, "#theme").textContent, find(window, "#follow").textContent,
    ...[...window.document.querySelectorAll("input[type=checkbox]")].map(box => box.checked)].join();
  const scrub = (window, number) => {
    find(window, "#time").value = number;
    find(window, "#time").dispatchEvent(new window.Event("input", {bubbles: true}));
  };
  const hide = window => find(window, "#layers input").click();
  const wheel = window => find(window, "canvas").dispatchEvent(new window.WheelEvent("wheel", {deltaY: -200, clientX: 90, clientY: 70, bubbles: true}));
  const onKey = name => [name, window => key(window, name)];
  const ends = [["scrub", window => scrub(window, 30)], onKey("ArrowRight"), onKey("ArrowLeft"), onKey("Home"), onKey(" ")];
  const goOn = [["wheel", wheel], ["layer", hide], ...["+", "4", "]", "r", "d", "n", "0", "Shift"].map(onKey)];
  const isPlaying = window => find(window, "#play").textContent !== "▶";
  for (const [at, [name, act]] of [...ends, ...goOn].entries()) {
    const [player, touched] = at % 2 ? [left, right] : [right, left];
    scrub(player, 20);
    await wait(100);
    key(player, " ");
    await wait(150 + 7 * at);
    const before = clocks();
    act(touched);
    await wait(120);
    if (at >= ends.length) {
      check(`${name}: both play on: ${before}, ${clocks()}`, windows.every(isPlaying) && clocks() !== before);
      key(at % 4 < 2 ? player : touched, " ");
      await wait(100);
    }
    await soon();
    check(`${name}: the same: ${windows.map(state).join(" and ")}`, state(left) === state(right) && !isPlaying(left));
    check(`${name}: the same picture`, picture(left) === picture(right));
    if (name === "scrub") check("the moment of the one touched last", / frame 30 .* frame 30 /.test(clocks()));
    if (name === "n") check("the body that is followed", find(player, "#follow").textContent.startsWith("following body"));
  }
  scrub(left, 10);
  scrub(right, 20);
  scrub(left, 40); // all on their way
  await soon();
  check(`three touches: ${clocks()}`, / frame 40 .* frame 40 /.test(clocks()));
)");
    EXPECT_THAT(results, Not(HasSubstr("WRONG")));
    EXPECT_THAT(results, HasSubstr("right three touches"));
}

} // namespace
} // namespace boxreel
