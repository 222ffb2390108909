// SPDX-License-Identifier: MIT
// What `boxreel bench --render` makes of the figures of made-up renderers.
#include <bench/RenderBench.h>

#include <gmock/gmock.h>

#include <cmath>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kLine = "1500-720p\t1500 shapes\tcount=1500 width=1280 height=720 "
                              "full=0.005 changed=0.0005 none=0.00005 empty=1.3 rms=1.1";

RenderTimes Taking(double seconds)
{
    return {seconds, 2.0 * seconds, 1.5 * seconds, 0.5 * seconds};
}

/// Meets every goal of the case.
RenderFigures Ours(const char* threads)
{
    RenderFigures figures;
    figures.method = "boxreel 1";
    figures.by = "OSMesa";
    figures.isOurs = true;
    figures.threads = threads;
    figures.full = Taking(0.004);
    figures.together = Taking(0.0003);
    figures.apart = Taking(0.0004);
    figures.none = Taking(0.00001);
    figures.empty = Taking(0.00025);
    figures.floor = Taking(0.0002);
    figures.rms = 0.75;
    figures.most = 12.0;
    figures.edgePixels = 1000.0;
    return figures;
}

RenderFigures Peer(const char* name, double seconds, double rms)
{
    RenderFigures figures;
    figures.method = name;
    figures.threads = "0";
    figures.full = Taking(seconds);
    figures.empty = Taking(0.0001);
    figures.rms = rms;
    figures.most = 30.0;
    figures.edgePixels = 1000.0;
    return figures;
}

RenderResult Two()
{
    return {ParseRenderCase(kLine), {Ours("0"), Ours("own"), Peer("Cairo", 0.03, 2.5)}};
}

std::vector<std::string> Missed(const RenderResult& result)
{
    std::vector<std::string> missed;
    for (const RenderGoal& goal : RenderGoals(result))
    {
        if (!goal.IsMet())
        {
            missed.push_back(goal.what);
        }
    }
    return missed;
}

TEST(RenderBench, ReadsACaseOfAProgramsList)
{
    const RenderCase info = ParseRenderCase(kLine);
    EXPECT_EQ(info.name, "1500-720p");
    EXPECT_EQ(info.what, "1500 shapes");
    EXPECT_EQ(info.count, 1500);
    EXPECT_EQ(info.width, 1280);
    EXPECT_EQ(info.height, 720);
    EXPECT_EQ(info.goalFull, 0.005);
    EXPECT_EQ(info.goalChanged, 0.0005);
    EXPECT_EQ(info.goalNone, 0.00005);
    EXPECT_EQ(info.goalEmpty, 1.3);
    EXPECT_EQ(info.goalRms, 1.1);
    EXPECT_EQ(ParseRenderCase("a\tb\tcount=1 width=2 height=3").goalFull, 0.0);
}

TEST(RenderBench, ReadsTimesAndErrorsAndWhatIsNotMeasured)
{
    const auto read = ParseRenderLines(
        "Hello\n"
        R"({"method":"a","by":"GL","works":{"full":{"cpu":0.01,"wall":0.02,"submit":0.015,)"
        R"("read":0.005}},"wrong":"apart"})"
        "\n"
        R"({"method":"b","rms":1.5,"most":9,"edgePixels":77})"
        "\n");
    ASSERT_TRUE(read);
    const std::vector<RenderFigures>& methods = *read;
    ASSERT_EQ(methods.size(), 2u);
    EXPECT_EQ(methods[0].by, "GL");
    EXPECT_EQ(methods[0].wrong, "apart");
    EXPECT_EQ(methods[0].full.cpu, 0.01);
    EXPECT_EQ(methods[0].full.read, 0.005);
    EXPECT_TRUE(std::isnan(methods[0].together.cpu));
    EXPECT_EQ(methods[1].rms, 1.5);
    EXPECT_EQ(methods[1].edgePixels, 77.0);
    for (const char* other : {"", "Usage", "{}", R"({"method":"a"})", "{\"method\":", "{\n}"})
    {
        EXPECT_FALSE(ParseRenderLines(other)) << other;
    }
}

TEST(RenderBench, HoldsOursWithOneThreadAgainstEachGoal)
{
    RenderResult result = Two();
    EXPECT_EQ(RenderGoals(result).size(), 6u);
    EXPECT_THAT(Missed(result), IsEmpty());
    result.methods[1].full = Taking(1.0);
    result.methods[2].rms = 20.0;
    EXPECT_THAT(Missed(result), IsEmpty()) << "goals are for ours, with one thread";
    RenderFigures& ours = result.methods[0];
    ours.full = Taking(0.0051);
    EXPECT_THAT(Missed(result), ElementsAre("full redraw"));
    ours.together = ours.apart = Taking(0.00051);
    EXPECT_THAT(Missed(result),
                ElementsAre("full redraw", "5 % changed together", "5 % changed apart"));
    ours = Ours("0");
    ours.none = Taking(0.00006);
    ours.empty = Taking(0.00027);
    ours.rms = 1.11;
    EXPECT_THAT(Missed(result),
                ElementsAre("unchanged", "empty over clear and read", "RMSE at edges"));
    ours = Ours("0");
    ours.apart = {};
    EXPECT_THAT(Missed(result), ElementsAre("5 % changed apart")) << "not measured is not met";
    result.info = ParseRenderCase("a\tb\tcount=1 width=2 height=3");
    EXPECT_THAT(RenderGoals(result), IsEmpty());
}

TEST(RenderBench, MarksInTheTableWhatMissesItsGoal)
{
    RenderResult result = Two();
    EXPECT_THAT(RenderTable({result}).substr(0, RenderTable({result}).find("Times are")),
                Not(HasSubstr("!")));
    EXPECT_THAT(RenderTable({result}), HasSubstr("goal met:    full redraw"));
    result.methods[0].full = Taking(0.0123);
    result.methods[0].rms = 1.5;
    EXPECT_THAT(RenderTable({result}), HasSubstr(" 12.3! "));
    EXPECT_THAT(RenderTable({result}), HasSubstr(" 1.50! "));
    EXPECT_THAT(RenderTable({result}), Not(HasSubstr("24.6!"))) << "goals are for CPU time";
    EXPECT_THAT(RenderTable({result}), HasSubstr("goal MISSED: full redraw "));
}

TEST(RenderBench, SumsUpWhatOneThreadReaches)
{
    RenderResult result = Two(), other = Two();
    result.methods[1].full = Taking(0.009);
    other.info.name = "50-720p";
    other.methods[2].failure = "failed";
    EXPECT_THAT(RenderSummary({result, other}),
                testing::EndsWith(
                    "1500-720p            4.00     0.300     0.400    0.0100        1.25    0.75"
                    "         30.0    2.50\n"
                    "50-720p              4.00     0.300     0.400    0.0100        1.25    0.75"
                    "            -       -\n"));
}

TEST(RenderBench, TellsWhoFailedAndWhatWasDrawnWrong)
{
    RenderResult result = Two();
    result.methods[0].wrong = "together";
    result.methods[2].failure = "failed";
    EXPECT_THAT(RenderTable({result}), HasSubstr("wrong: together\n"));
    EXPECT_THAT(RenderTable({result}), HasSubstr("Cairo failed\n"));
    EXPECT_THAT(RenderJson({result}), HasSubstr("\"failure\": \"failed\""));
}

TEST(RenderBench, ReadsWhatItWrote)
{
    RenderResult result = Two();
    result.methods[1].wrong = "apart";
    result.methods.push_back(Peer("broken", 1.0, 1.0));
    result.methods.back().failure = "failed";
    RenderResult other = Two();
    other.info = ParseRenderCase("a\tb\tcount=1 width=2 height=3");
    const std::string text = RenderJson({result, other});
    const auto again = ParseRenderJson(text, "a.json");
    ASSERT_TRUE(again);
    EXPECT_EQ(RenderJson(*again), text);
    EXPECT_EQ(RenderTable(*again), RenderTable({result, other}));
    for (const char* no :
         {"", "{}", "[]", R"({"cases":[]})", R"({"cases":[1]})",
          R"({"cases":[{"case":"a","shapes":1,"width":1,"height":1,"methods":[]}]})",
          R"({"cases":[{"case":"a","shapes":1,"width":1,"height":1,"methods":[{"method":"x"}]}]})",
          R"({"cases":[{"case":"a","methods":[{"method":"x","failure":"failed"}]}]})"})
    {
        EXPECT_FALSE(ParseRenderJson(no, "a.json")) << no;
    }
}

TEST(RenderBench, ChartsACurveARendererAndKindOfChangeThroughTheNumbersOfShapes)
{
    RenderResult many = Two(), few = Two();
    few.info = ParseRenderCase("50-720p\tfew\tcount=50 width=1280 height=720");
    few.methods[0].full = Taking(0.001);
    few.methods[0].together = Taking(0.0009);
    const auto chart = RenderChart({many, few});
    ASSERT_TRUE(chart);
    std::vector<std::pair<std::string, ChartStroke>> curves;
    for (const ChartLine& line : chart->lines)
    {
        curves.emplace_back(line.series.name, line.series.stroke);
        ASSERT_EQ(line.points.size(), 2u);
        EXPECT_EQ(line.points[1].label, "1,500") << "from few shapes to many";
    }
    EXPECT_THAT(curves, ElementsAre(testing::Pair("boxreel 1", ChartStroke::Solid),
                                    testing::Pair("boxreel 1", ChartStroke::Dashed),
                                    testing::Pair("boxreel 1", ChartStroke::Dotted),
                                    testing::Pair("Cairo", ChartStroke::Solid)));
    EXPECT_EQ(chart->lines[0].points[0].label, "50");
    EXPECT_DOUBLE_EQ(chart->lines[0].points[1].x, 4.0) << "[ms]";
    EXPECT_EQ(chart->lines[0].points[1].y, 0.75);
    EXPECT_EQ(chart->lines[1].points[0].label, "") << "as long as a full redraw, at its place";
}

TEST(RenderBench, TellsTheDotsOfASinglePictureApart)
{
    const auto chart = RenderChart({Two()});
    ASSERT_TRUE(chart);
    EXPECT_EQ(chart->lines[0].points[0].label, "all shapes changed");
    EXPECT_EQ(chart->lines[1].points[0].label, "5 % changed, together");
    for (const auto& entry : chart->legend)
    {
        EXPECT_NE(entry.key, LegendKey::Stroke) << "dots have none";
    }
    EXPECT_THAT(chart->frame.subtitle, HasSubstr("1,500 shapes"));
}

TEST(RenderBench, ChartsTheGoalsOnce)
{
    const auto chart = RenderChart({Two()});
    ASSERT_TRUE(chart);
    ASSERT_EQ(chart->rules.size(), 3u);
    EXPECT_EQ(chart->rules[0].value, 1.1);
    EXPECT_FALSE(chart->rules[0].upright);
    EXPECT_DOUBLE_EQ(chart->rules[1].value, 5.0);
    EXPECT_DOUBLE_EQ(chart->rules[2].value, 0.5);
    EXPECT_TRUE(chart->tintsCorner);
}

TEST(RenderBench, ChartsOneOfTwoThatDrawTheSameAndSaysSo)
{
    RenderResult result = Two();
    result.methods.push_back(Peer("Cairo, best", 0.031, 2.5));
    const auto chart = RenderChart({result});
    ASSERT_TRUE(chart);
    EXPECT_EQ(chart->lines.back().series.name, "Cairo");
    EXPECT_THAT(chart->frame.notes.back(), HasSubstr("\"Cairo, best\" draws what \"Cairo\" does"));
    result.methods.back().most = 31.0;
    EXPECT_EQ(RenderChart({result})->lines.back().series.name, "Cairo, best");
}

TEST(RenderBench, ChartsNothingWhereNothingRan)
{
    RenderResult result = Two();
    for (RenderFigures& figures : result.methods)
    {
        figures.failure = "failed";
    }
    EXPECT_FALSE(RenderChart({result}));
    EXPECT_FALSE(RenderChart({}));
}

} // namespace
} // namespace boxreel
