// SPDX-License-Identifier: MIT
// The program of docs/figures.md.
#include "../base/TemporaryFolder.h"
#include "Shown.h"

#include <render/Png.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <set>
#include <string>

using namespace boxreel;

namespace
{

TEST(DrawWorld, DrawsThePicturesThatItPromises)
{
    const TemporaryFolder folder;
    ASSERT_EQ(std::system(("cd '" + (folder / "").string() + "' && " BOXREEL_DRAW_WORLD).c_str()),
              0);
    const Result<Frame> frame = ReadPng(folder / "ball.png");
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->width, 640);
    std::set<int> greens;
    for (std::size_t i = 1; i < frame->rgba.size(); i += 4)
    {
        greens.insert(frame->rgba[i]);
    }
    EXPECT_GT(greens.size(), 20u) << "a box, a ball, and a trail that fades";
    const std::string svg = ReadBytes(folder / "ball.svg");
    EXPECT_THAT(svg, testing::HasSubstr("<g id=\"body-1\" class=\"shapes\">"));
    EXPECT_THAT(svg, testing::HasSubstr("<g id=\"trails\" class=\"trails\">"));
    EXPECT_THAT(svg, testing::HasSubstr(">A throw.</text>"));
}

TEST(DrawWorld, IsShownUnchangedInTheDocumentation)
{
    EXPECT_TRUE(IsShown("draw_world.cpp", "figures.md"));
}

} // namespace
