// SPDX-License-Identifier: MIT
#include <film/RenderReport.h>

#include <gmock/gmock.h>

#include <regex>
#include <string>
#include <vector>

namespace boxreel
{
namespace
{

using testing::ElementsAre;

std::vector<double> NumbersOf(const std::string& text)
{
    const std::regex number("[0-9]+(\\.[0-9]+)?");
    std::vector<double> numbers;
    for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i)
    {
        numbers.push_back(std::stod(i->str()));
    }
    return numbers;
}

TEST(RenderReport, PrintsDrawingStatistics)
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
    // 600 frames: 38 as a whole, 412 in part, 150 unchanged. Pixels drawn: 9.2 %. 310200 items:
    // 10 % drawn, 70 % unchanged, 20 % outside the picture, 50 % reused. 8410 draw calls: 14 a
    // frame.
    EXPECT_THAT(NumbersOf(DescribeDrawing(totals)),
                ElementsAre(600, 38, 412, 150, 9.2, 310200, 10.0, 70.0, 20.0, 50.0, 8410, 14.0));
}

TEST(RenderReport, PrintsSimulationStatistics)
{
    EXPECT_THAT(NumbersOf(DescribeSimulation({.firstStep = 0, .steps = 600})), ElementsAre(600));
    EXPECT_THAT(NumbersOf(DescribeSimulation({.firstStep = 500, .steps = 100})),
                ElementsAre(100, 500));
}

TEST(RenderReport, PrintsNoNanWithoutFrames)
{
    EXPECT_THAT(DescribeDrawing({}), testing::Not(testing::HasSubstr("nan")));
    EXPECT_THAT(NumbersOf(DescribeDrawing({})), testing::Each(0.0));
}

} // namespace
} // namespace boxreel
