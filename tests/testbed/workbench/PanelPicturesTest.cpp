// SPDX-License-Identifier: MIT
// The panels of a window with what no script can show: the buttons that write files, the times of
// steps, all keys. Their references are those of the scripts; BOXREEL_GOLDEN_ACCEPT=changed accepts
// one again.
#include <golden/GoldenTest.h>
#include <render/Renderer.h>
#include <ui/Panels.h>

#include <cmath>

namespace boxreel
{
namespace
{

constexpr int kWidth = 336;
constexpr int kHeight = 1040; // nothing of it is below the edge

/// A scene that was filmed for two seconds; times that a person can check against the panel.
PanelFacts FactsAt(std::int64_t step)
{
    PanelFacts facts;
    facts.scene = "Tumbler";
    facts.step = step;
    facts.seconds = double(step) / 60.0;
    facts.bodies = 213;
    facts.awake = 187;
    facts.contacts = 340 + int(step % 40);
    facts.joints = 1;
    facts.proxies = 216;
    facts.treeHeight = 10;
    facts.treeBalance = 3;
    facts.treeQuality = 8.25;
    facts.keys = {{'f', "turn faster"}, {' ', "stop"}};
    facts.description = {{"turns", "0.5"}};
    facts.filmSeconds = 2.0;
    facts.message = "tumbler.svg is written.";
    std::array<float, kStageNames.size()> times{};
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        times[i] = (2.0f + float(step % 8) * 0.125f) / float(i + 1); // [ms]
    }
    facts.times = times;
    return facts;
}

TEST(PanelPictures, ShowFilesTimesAndKeysOfAWindow)
{
    Result<Panels> panels = Panels::Create(kWidth, kHeight, 1.0);
    ASSERT_TRUE(panels) << panels.GetError().Text();
    panels->Controls().SetOpenSections({"Statistics", "Profile", "Keys"});
    PanelChoices choices;
    for (std::int64_t step = 1; step <= 60; ++step)
    {
        panels->Observe(FactsAt(step));
    }
    for (int frame = 0; frame < 4; ++frame) // until what was opened stands still
    {
        panels->Build(FactsAt(60), choices, {});
    }
    Result<Renderer> renderer = Renderer::Create({.width = kWidth, .height = kHeight});
    ASSERT_TRUE(renderer) << renderer.GetError().Text();
    Frame frame;
    ASSERT_TRUE(renderer->Draw({}, {kWidth, kHeight, 0.0, 0.0, 20.0}, frame, &panels->Picture()));
    EXPECT_GOLDEN(frame, "panels/window");
}

} // namespace
} // namespace boxreel
