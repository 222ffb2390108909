// SPDX-License-Identifier: MIT
#include <film/RenderReport.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

TEST(RenderReport, PrintsAlignedStatistics)
{
    RenderTotals totals;
    totals.frames = 600;
    totals.framesUnchanged = 150;
    totals.framesInPart = 412;
    totals.pixels = 600 * 1000;
    totals.pixelsDrawn = 55'500;
    totals.items = 310'200;
    totals.itemsDrawn = 31'020;
    totals.itemsOutside = 62'040;
    totals.itemsReused = 155'100;
    totals.drawCalls = 8410;
    EXPECT_EQ(DescribeDrawing(totals),
              "Rendering:\n"
              "  frames            600   38 as a whole, 412 in part, 150 unchanged\n"
              "  pixels          9.2 %   drawn, the rest unchanged\n"
              "  items          310200   10.0 % drawn, 70.0 % unchanged, 20.0 % outside the "
              "picture\n"
              "                 50.0 %   reused from the frame before\n"
              "  draw calls       8410   14.0 a frame");
}

TEST(RenderReport, PrintsSimulationStatistics)
{
    EXPECT_EQ(DescribeSimulation({.firstStep = 0, .steps = 600}),
              "Simulation:\n  steps             600   from the start");
    EXPECT_EQ(DescribeSimulation({.firstStep = 500, .steps = 100}),
              "Simulation:\n"
              "  steps             100   from the snapshot of step 500 on");
}

TEST(RenderReport, PrintsNoNanWithoutFrames)
{
    EXPECT_THAT(DescribeDrawing({}), testing::Not(testing::HasSubstr("nan")));
    EXPECT_THAT(DescribeDrawing({}), testing::HasSubstr("\n  items               0   0.0 % drawn"));
}

} // namespace
} // namespace boxreel
