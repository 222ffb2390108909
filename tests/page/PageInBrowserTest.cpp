// SPDX-License-Identifier: MIT
// Pages of scenes in Chromium: the pixels of `boxreel shot`, the positions of the draw list, and
// the controls.
#include "PageInBrowser.h"

#include <Box2D/Dynamics/b2Body.h>
#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <debugdraw/WorldGlyphs.h>
#include <golden/Compare.h>
#include <page/PageWriter.h>
#include <render/Png.h>
#include <render/Renderer.h>
#include <session/SessionPanels.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace boxreel
{
namespace
{

using testing::HasSubstr;
using testing::Not;

struct Shown
{
    const char* scene;
    const char* layers;
    const char* theme;
};

class PagePixels : public PageInBrowser, public testing::WithParamInterface<Shown>
{};

/// The picture in base64.
Result<Frame> FrameOf(std::string_view base64, const TemporaryFolder& folder)
{
    RETURN_IF_ERROR(WriteWhole(folder / "page.png", test::FromBase64(base64), true));
    return ReadPng(folder / "page.png");
}

TEST_P(PagePixels, EqualThoseOfARenderer)
{
    constexpr int kStep = 150;
    const Theme theme = *FindTheme(GetParam().theme);
    const std::string page = PageOf(GetParam().scene, GetParam().layers, kStep, theme);
    const std::string results = Run(page, R"(
(async () => {
  const player = await opened;
  const frame = await player.film.frameLater(150);
  leave(`${drawExactly(player, frame)}\n${drawPlaying(player, frame)}\n${drawDense(player, frame)}`);
})();
)");
    const std::size_t second = results.find('\n') + 1;
    const std::size_t third = results.find('\n', second) + 1;
    const Result<Frame> shown = FrameOf(results, folder);
    const Result<Frame> playing = FrameOf(std::string_view(results).substr(second), folder);
    const Result<Frame> dense = FrameOf(std::string_view(results).substr(third), folder);
    ASSERT_TRUE(shown && playing && dense) << results.substr(0, 400);
    Result<Renderer> renderer = Renderer::Create({.theme = theme});
    ASSERT_TRUE(renderer);
    Frame drawn;
    ASSERT_TRUE(renderer->Draw(content.list, content.camera, drawn));
    const Comparison comparison = Compare(drawn, *shown, CompareSettings::CrossMachine());
    EXPECT_TRUE(comparison.equal) << comparison.Text();
    const Comparison moving = Compare(drawn, *playing, CompareSettings::CrossMachine());
    EXPECT_LE(double(moving.overTolerance), 0.002 * double(moving.compared)) << moving.Text();
    Camera camera = content.camera;
    camera.width *= 2;
    camera.height *= 2;
    camera.pixelsPerMeter *= 2.0;
    Result<Renderer> large = Renderer::Create(
        {.width = camera.width, .height = camera.height, .theme = theme, .scale = 2.0});
    ASSERT_TRUE(large && large->Draw(content.list, camera, drawn));
    const Comparison fine = Compare(drawn, *dense, CompareSettings::CrossMachine());
    EXPECT_TRUE(fine.equal) << fine.Text();
}

INSTANTIATE_TEST_SUITE_P(Scenes, PagePixels,
                         testing::Values(Shown{"dominos", "shapes,joints", "classic"},
                                         Shown{"pyramid", "shapes,joints,contacts", "classic"},
                                         Shown{"tumbler", "shapes,joints", "dark"},
                                         Shown{"car", "shapes,joints,centers,velocities", "print"},
                                         Shown{"web", "shapes,joints,aabbs", "okabe-ito"}),
                         [](const auto& shown) { return shown.param.scene; });

struct Moment
{
    const char* scene;
    int frame;
};

void PrintTo(const Moment& moment, std::ostream* out)
{
    *out << moment.scene << ", frame " << moment.frame;
}

class PageLayers : public PageInBrowser, public testing::WithParamInterface<Moment>
{
protected:
    /// Expects that the page shows what the renderer draws of the list.
    void ExpectSame(const std::string& name, const DrawList& list, const Camera& camera,
                    std::string_view png)
    {
        const Result<Frame> shown = FrameOf(png, folder);
        ASSERT_TRUE(shown) << name << ": " << png.substr(0, 400);
        Result<Renderer> renderer = Renderer::Create({});
        ASSERT_TRUE(renderer);
        Frame drawn;
        ASSERT_TRUE(renderer->Draw(list, camera, drawn));
        const Comparison comparison = Compare(drawn, *shown, CompareSettings::CrossMachine());
        EXPECT_TRUE(comparison.equal) << name << ": " << comparison.Text();
    }
};

/// The shapes and one more layer.
DrawList ListOf(const DrawList& all, DrawLayer layer)
{
    DrawList list = all;
    std::erase_if(list.items, [layer](const DrawItem& item) {
        return item.layer != DrawLayer::Shapes && item.layer != layer;
    });
    return list;
}

TEST_P(PageLayers, EqualThoseOfARenderer)
{
    std::string layers;
    for (const LayerInfo& info : kOptionalLayers)
    {
        layers += (layers.empty() ? "" : ",") + std::string(info.option);
    }
    const std::string page = PageOf(GetParam().scene, layers, GetParam().frame);
    const Camera near = zoomed.camera;
    std::ostringstream views;
    views.precision(17);
    views << "{x: " << near.centerX << ", y: " << near.centerY << ", scale: " << near.pixelsPerMeter
          << "}";
    const std::string results = Run(page, R"(
(async () => {
  const player = await opened, {film} = player;
  const frame = await film.frameLater(film.frames - 1), lines = [];
  for (const view of [film.viewOf(frame), )" + views.str() +
                                              R"(]) {
    for (const layer of film.layers.slice(0, 14)) {
      const hidden = new Set(film.layers.map(known => known.number).filter(number => number !== 0 && number !== layer.number));
      lines.push(drawExactly(player, frame, view, hidden));
    }
  }
  lines.push(drawExactly(player, frame), drawExactly(player, frame, )" +
                                              views.str() +
                                              R"());
  leave(lines.join("\n"));
})().catch(error => leave(`WRONG ${error.stack}`));
)");
    std::istringstream pictures(results);
    std::string png;
    const auto expectNext = [&](const std::string& name, const DrawList& list,
                                const Camera& camera) {
        ASSERT_TRUE(std::getline(pictures, png)) << results.substr(0, 400);
        ExpectSame(name, list, camera, png);
    };
    // Where names are depends on the other layers.
    Result<SceneSession> named = Open(GetParam().scene, "shapes,names", 1.0);
    ASSERT_TRUE(named);
    named->AdvanceTo(GetParam().frame);
    FrameContent names;
    named->Fill(names);
    const auto listOf = [](const LayerInfo& info, const DrawList& all, const DrawList& withNames) {
        return ListOf(info.layer == DrawLayer::Labels ? withNames : all, info.layer);
    };
    for (const LayerInfo& info : kOptionalLayers)
    {
        expectNext(info.option, listOf(info, content.list, names.list), content.camera);
    }
    names = Nearer(*named);
    for (const LayerInfo& info : kOptionalLayers)
    {
        expectNext(std::string(info.option) + ", zoomed", listOf(info, zoomed.list, names.list),
                   near);
    }
    expectNext("all layers", content.list, content.camera);
    expectNext("all layers, zoomed", zoomed.list, near);
}

// In the frames other than 100, labels begin at half a pixel. The car, prismatic, pulleys and web
// have signs of joints without dashes.
INSTANTIATE_TEST_SUITE_P(Scenes, PageLayers,
                         testing::Values(Moment{"breakable", 100}, Moment{"car", 0},
                                         Moment{"motor-joint", 75}, Moment{"prismatic", 100},
                                         Moment{"pulleys", 100}, Moment{"pyramid", 100},
                                         Moment{"rain", 150}, Moment{"ray-cast", 45},
                                         Moment{"revolute", 100}, Moment{"sphere-stack", 0},
                                         Moment{"web", 20}),
                         [](const auto& moment) {
                             std::string name = moment.param.scene;
                             std::erase(name, '-');
                             return name;
                         });

TEST_F(PageInBrowser, PlacesItemsOfEveryStepAsTheList)
{
    const std::string page = PageOf("dominos", "shapes,joints,contacts", 300);
    std::ostringstream expected;
    for (const Vec2 point : content.list.points)
    {
        expected << "," << double(point.x) << "," << double(point.y);
    }
    // Steps before are read out of order, which must not matter.
    const std::string results = Run(page, R"(
(async () => {
  const {film} = await opened;
  for (const number of [250, 10, 299]) await film.frameLater(number);
  const frame = await film.frameLater(300);
  const texts = [];
  let at = 0;
  for (const track of frame.tracks) {
    const points = new Float64Array(2 * track.form.pointCount);
    placePoints(track.form, frame.numbers, at, film.quantum, points);
    at += track.form.numbers;
    let first = 0;
    for (const item of track.form.items) {
      texts.push(`${item.kind} ${track.owner} ${points[first].toFixed(7)} ${points[first + 1].toFixed(7)}`);
      first += 2 * item.count;
    }
  }
  leave(`${film.fullScale}\n${texts.join("\n")}`);
})();
)");
    std::istringstream lines(results);
    double fullScale = 0.0;
    ASSERT_TRUE(lines >> fullScale) << results;
    for (const DrawItem& item : content.list.items)
    {
        int kind = 0;
        std::int64_t owner = 0;
        double x = 0.0;
        double y = 0.0;
        ASSERT_TRUE(lines >> kind >> owner >> x >> y);
        const Vec2 first = content.list.points[item.first];
        EXPECT_EQ(kind, int(item.kind));
        EXPECT_EQ(owner, item.owner == kNoOwner ? -1 : std::int64_t(item.owner));
        EXPECT_LE(std::abs(x - double(first.x)) * fullScale, kPagePixelError);
        EXPECT_LE(std::abs(y - double(first.y)) * fullScale, kPagePixelError);
    }
}

TEST_F(PageInBrowser, HasWorkingControlsWithoutConsoleErrors)
{
    const std::string page = PageOf("dominos", "shapes,joints,contacts", 299);
    const std::string results = Run(page, R"(
(async () => {
  const lines = [];
  const check = (what, is) => lines.push(`${is ? "right" : "WRONG"} ${what}`);
  const key = (name, more = {}) => dispatchEvent(new KeyboardEvent("keydown", {key: name, ...more}));
  // Chromium hardly ever draws while its time is virtual, so frames come from a timer.
  window.requestAnimationFrame = draw => setTimeout(() => draw(performance.now()), 16);
  const soon = () => new Promise(done => setTimeout(done, 100));
  const later = () => new Promise(done => setTimeout(done, 300)); // when the address is set
  const player = await opened, {film, view} = player;
  await soon();
  check("begins at rest", player.number === 0 && !player.isPlaying);
  key("ArrowRight"); key("ArrowRight"); key("ArrowLeft");
  check("arrows step", player.number === 1);
  key("ArrowRight", {shiftKey: true});
  check("shift steps a second", player.number === 61);
  key("End");
  check("end", player.number === 299);
  await later();
  check("the address is a link to the moment", location.hash === `#t=${Number((299 / 60).toFixed(6))}s`);
  location.hash = "#t=3.2s&at=1,20,4";
  await soon();
  check("a link sets the time", player.number === 192);
  check("a link sets the view", view.own.x === 1 && view.own.y === 20 && view.own.height === 4);
  check("the slider follows", $("time").value === "192" && $("clock").textContent.startsWith("3.200 s"));
  key("0");
  check("0 resets the view", view.own === null);
  const canvas = player.canvas;
  const send = (type, x, y, more = {}) => canvas.dispatchEvent(
    new (type === "wheel" ? WheelEvent : type === "dblclick" ? MouseEvent : PointerEvent)(type, {clientX: x, clientY: y, pointerId: 1, cancelable: true, ...more}));
  canvas.setPointerCapture = () => {};
  const frame = await film.frameLater(192);
  await soon();
  const body = describeBody(film, frame, 13), filmed = view.of(frame);
  // Events of the mouse have whole pixels.
  const x = Math.round((0.5 * canvas.width + (body.x - filmed.x) * filmed.scale) / player.ratio);
  const y = Math.round((0.5 * canvas.height - (body.y - filmed.y) * filmed.scale) / player.ratio);
  const [pointedX, pointedY] = view.toWorld(filmed, ...player.inCanvas([x, y]));
  send("pointermove", x, y);
  await soon();
  check("a body pointed at is described", /^body 13 body 13\nposition .* m\nangle .*\nvelocity .* m\/s\nspin/.test($("body").textContent));
  send("wheel", x, y, {deltaY: -400});
  const [underX, underY] = view.toWorld(view.of(frame), ...player.inCanvas([x, y]));
  check("the wheel zooms about the pointer", view.own !== null && Math.hypot(underX - pointedX, underY - pointedY) < 1e-6);
  send("pointerdown", x, y); send("pointermove", x + 30, y + 10);
  const [movedX] = view.toWorld(view.of(frame), ...player.inCanvas([x + 30, y]));
  check("a drag pans", Math.abs(movedX - pointedX) < 1e-6);
  send("pointerup", x + 30, y + 10);
  check("a drag follows nothing", view.followed === -1);
  send("pointerdown", x + 30, y + 10); send("pointerup", x + 30, y + 10);
  await later();
  check("a click follows a body", view.followed === 13 && location.hash.includes("follow=13"));
  player.show(299);
  await soon();
  const end = await film.frameLater(299), there = describeBody(film, end, 13);
  const [followedX, followedY] = view.toWorld(view.of(end), ...player.inCanvas([x + 30, y + 10]));
  check("the view goes with it", Math.hypot(followedX - there.x - (pointedX - body.x), followedY - there.y - (pointedY - body.y)) < 1e-6 && there.x !== body.x);
  key("0");
  for (let i = 0; i < 60; ++i) key("+");
  check("zoom ends at the full scale", Math.abs(view.of(end).scale - film.fullScale) < 1e-6 * film.fullScale);
  key("0");
  await later();
  const isExact = (frame = end) => {
    const look = {view: view.of(frame), ratio: player.ratio, theme: film.themes[player.theme], hidden: player.hidden};
    const exact = Object.assign(document.createElement("canvas"), {width: canvas.width, height: canvas.height});
    player.exactPainter.draw(exact, frame, look);
    return canvas.toDataURL() === exact.toDataURL();
  };
  check("a picture that rests is exact", isExact());
  player.show(100);
  key(" ");
  await soon();
  key(" ");
  await later();
  check("also one that was paused", player.number > 100 && isExact(film.frame(player.number)));
  player.show(299);
  Object.defineProperty(player, "ratio", {value: 2, configurable: true});
  player.resize();
  await later();
  check("also on a screen with small pixels", isExact());
  delete player.ratio;
  player.resize();
  document.querySelector("main").style.width = "500px";
  player.resize(); // as the observer calls it
  check("a resize draws at once", canvas.width === Math.round(500 * player.ratio) && new Set(new Uint32Array(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size > 2);
  document.querySelector("main").style.width = "";
  player.resize(); // as the observer calls it
  const boxes = [...$("layers").querySelectorAll("input")];
  check("layers that are there have boxes", $("layers").querySelector("div").textContent === "ShapesJointsContact points" || $("layers").querySelector("div").textContent === "ShapesContact points");
  boxes[0].click();
  check("a layer is off", player.hidden.has(0));
  boxes[0].click();
  key("d");
  check("d makes it light", document.documentElement.classList.contains("light"));
  key("]"); key("]");
  check("faster", player.speed === 4 && $("speed").value === "4");
  key(" ");
  check("space plays", player.isPlaying);
  key(" ");
  check("space pauses", !player.isPlaying);
  key("?");
  check("? shows the keys", $("keys").open);
  leave(lines.join("\n"));
})().catch(error => leave(`WRONG ${error.stack}`));
)");
    EXPECT_THAT(results, Not(HasSubstr("WRONG")));
    EXPECT_THAT(results, HasSubstr("right ? shows the keys"));
}

// The film's own camera moves with the car, so a view that is not the reader's moves too.
TEST_F(PageInBrowser, FollowsBodyWhenTheFilmCameraMoves)
{
    const std::string page = PageOf("car", "shapes", 300);
    EXPECT_EQ(Run(page, R"(
(async () => {
  const player = await opened, {film, view} = player, lines = [];
  const check = (what, isRight) => lines.push(`${isRight ? "right" : "WRONG"} ${what}`);
  const at = async number => {
    await film.frameLater(number);
    player.show(number);
    player.draw();
    const body = describeBody(film, film.frame(number), view.followed), seen = view.of(film.frame(number));
    return [(body.x - seen.x) * seen.scale, (body.y - seen.y) * seen.scale];
  };
  const near = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) < 0.01;
  const moves = film.viewOf(await film.frameLater(300)).x - film.viewOf(await film.frameLater(0)).x;
  check("the film moves", Math.abs(moves) > 5);
  player.follow(bodiesOf(film, film.frame(0)).at(-1));
  const start = await at(0);
  check("forward", near(await at(300), start));
  check("back", near(await at(0), start));
  location.hash = "#t=2s&at=0,0,20&follow=" + view.followed;
  player.openLink();
  await film.frameLater(film.frameAt(2));
  player.draw();
  check("a link's view is the one it names", view.own.x === 0 && view.own.y === 0 && Math.abs(view.own.height - 20) < 1e-6);
  location.hash = "#t=1s";
  player.openLink();
  check("a link without a view has the film's", view.own === null && view.followed === -1);
  player.followNext(-1);
  check("keys go backwards", view.followed === bodiesOf(film, player.frame ?? film.frame(0)).at(-1) || player.frame === null);
  leave(lines.join("\n"));
})().catch(error => leave(`WRONG ${error.stack}`));
)"),
              "right the film moves\nright forward\nright back\nright a link's view is the one it "
              "names\nright a link without a view has the film's\nright keys go backwards\n");
}

TEST_F(PageInBrowser, DescribesBodiesAsTheWorldHasThem)
{
    constexpr int kLast = 245; // in the second group
    const std::string page = PageOf("chain", "shapes", kLast);
    const std::string results = Run(page, R"(
(async () => {
  const {film} = await opened;
  const before = await film.frameLater(244), frame = await film.frameLater(245);
  const lines = [];
  for (let number = 0; number < 200; ++number) {
    const body = describeBody(film, frame, number, before);
    if (body) lines.push([number, body.x, body.y, body.angle, body.vx, body.vy, body.spin].join(" "));
  }
  leave(lines.join("\n"));
})().catch(error => leave(`WRONG ${error.stack}`));
)");
    std::istringstream lines(results);
    std::uint32_t number = 0;
    double x = 0.0, y = 0.0, angle = 0.0, vx = 0.0, vy = 0.0, spin = 0.0;
    std::size_t compared = 0;
    for (; lines >> number >> x >> y >> angle >> vx >> vy >> spin; ++compared)
    {
        const auto body = std::find_if(last.begin(), last.end(), [&](const PageBody& known) {
            return known.number == number;
        });
        ASSERT_NE(body, last.end());
        constexpr double kShown = 0.00051; // half of the last digit on the page [m, rad]
        constexpr double kVelocity = kPageVelocityError + 0.001;
        EXPECT_NEAR(x, double(body->position.x), kShown) << number;
        EXPECT_NEAR(y, double(body->position.y), kShown) << number;
        EXPECT_NEAR(angle, double(body->angle), kShown) << number;
        EXPECT_NEAR(vx, double(body->velocity.x), kVelocity) << number;
        EXPECT_NEAR(vy, double(body->velocity.y), kVelocity) << number;
        EXPECT_NEAR(spin, double(body->spin), kVelocity) << number;
    }
    EXPECT_EQ(compared, last.size());
}

TEST_F(PageInBrowser, FindsContactsWithoutTheirLayer)
{
    const std::string page = PageOf("pyramid", "shapes", 0);
    const std::string results = Run(page, R"(
(async () => {
  const player = await opened, {film, view} = player;
  const frame = await film.frameLater(0);
  // The lowest row stands on the ground, whose top is at 0; its boxes are 1 m wide.
  const bodies = film.names ? Object.keys(film.names).map(Number).map(number => describeBody(film, frame, number)).filter(Boolean) : [];
  const lowest = bodies.filter(body => body.y > 0.1).sort((a, b) => a.y - b.y || a.x - b.x)[0];
  const touch = touchAt(film, frame, lowest.x - 0.4, 0.1, 0.5);
  leave(`${touch[0] - lowest.x} ${touch[1]} ${touchAt(film, frame, lowest.x, lowest.y, 0.2)}`);
})().catch(error => leave(`WRONG ${error.stack}`));
)");
    std::istringstream numbers(results);
    double x = 0.0, y = 0.0;
    std::string nothing;
    numbers >> x >> y >> nothing;
    EXPECT_NEAR(x, -0.5, 0.03) << results;
    EXPECT_NEAR(y, 0.0, 0.03) << results;
    EXPECT_EQ(nothing, "null") << "the middle of a box touches nothing";
}

TEST_F(PageInBrowser, ReportsADamagedPage)
{
    std::string page = PageOf("dominos", "shapes", 3);
    page.replace(page.find("\"forms\":\"") + 9, 8, "AAAAAAAA");
    const Outcome outcome = LoadInChromium(browser, page, R"(
opened.catch(() => leave(document.getElementById("message").textContent));
)" + std::string(kDrawScript),
                                           folder);
    EXPECT_THAT(ResultsOf(outcome), HasSubstr("This page is damaged"));
}

} // namespace
} // namespace boxreel
