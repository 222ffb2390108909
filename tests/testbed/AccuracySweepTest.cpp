// SPDX-License-Identifier: MIT
#include <bench/AccuracySweep.h>

#include <gmock/gmock.h>

#include <cmath>

namespace boxreel
{
namespace
{

using testing::HasSubstr;

constexpr const char* kLine =
    R"({"engine":"Box2D 2.4.1","case":"A-projectile","velocityIterations":20,"positionIterations":10,)"
    R"("hz":240,"subSteps":2,"error":0.04,"unit":"m","steps":480,"cpu":1e-06,"held":true,)"
    R"("remarks":{"gap_mm":0.5}})";

AccuracyFigures Run(const char* engine, double cpu, double error, bool held = true)
{
    AccuracyFigures run;
    run.engine = engine;
    run.cpu = cpu;
    run.error = error;
    run.held = held;
    return run;
}

AccuracyResult TwoEngines()
{
    AccuracyResult result{ParseAccuracyCase("A-projectile\tthrown\tunit=m goal=0.01 sub-steps=1"),
                          {}};
    result.runs = {Run("ours", 4e-6, 0.0),        Run("ours", 1e-6, 0.5),
                   Run("ours", 2e-6, 0.6),        Run("ours", 3e-6, 0.499),
                   Run("peer", 1e-6, 0.7),        Run("peer", 1e-7, 1e-9, false),
                   Run("burst", 1e-6, 1.0, false)};
    return result;
}

TEST(AccuracySweep, ReadsACaseOfAProgramsList)
{
    const AccuracyCase info =
        ParseAccuracyCase("K-far\tits way in 60 s\tunit=% goal=0.1 sub-steps=64");
    EXPECT_EQ(info.name, "K-far");
    EXPECT_EQ(info.what, "its way in 60 s");
    EXPECT_EQ(info.unit, "%");
    EXPECT_EQ(info.goal, 0.1);
    EXPECT_EQ(info.mostSubSteps, 64);
}

TEST(AccuracySweep, ReadsFiguresAfterWhatALibrarySays)
{
    const auto figures = ParseAccuracyFigures(std::string("Hello\n") + kLine + "\n");
    ASSERT_TRUE(figures);
    EXPECT_EQ(figures->engine, "Box2D 2.4.1");
    EXPECT_EQ(figures->settings.velocityIterations, 20);
    EXPECT_EQ(figures->settings.positionIterations, 10);
    EXPECT_EQ(figures->settings.subSteps, 2);
    EXPECT_EQ(figures->error, 0.04);
    EXPECT_TRUE(figures->held);
    EXPECT_DOUBLE_EQ(figures->CpuOfAFrame(), 4e-6) << "four steps of 1/240 s";
    ASSERT_EQ(figures->remarks.size(), 1u);
    EXPECT_EQ(figures->remarks[0].first, "gap_mm");
}

TEST(AccuracySweep, AnErrorThatIsNoNumberIsNotZero)
{
    std::string line = kLine;
    line.replace(line.find("0.04"), 4, "null");
    const auto figures = ParseAccuracyFigures(line);
    ASSERT_TRUE(figures);
    EXPECT_TRUE(std::isnan(figures->error));
    EXPECT_FALSE(ParseAccuracyFigures("Usage: …"));
}

TEST(AccuracySweep, VariesIterationsStepsAndTheSubStepsThatThereAre)
{
    EXPECT_EQ(AccuracySweep(1).size(), 16u);
    EXPECT_EQ(AccuracySweep(4).size(), 48u);
    EXPECT_EQ(AccuracySweep(1000).size(), 80u);
}

TEST(AccuracySweep, KeepsTheRunsThatBuyAccuracyWithTime)
{
    const std::vector<AccuracyFigures> best = BestRuns(TwoEngines(), "ours");
    ASSERT_EQ(best.size(), 2u);
    EXPECT_EQ(best[0].error, 0.5);
    EXPECT_EQ(best[1].error, 0.0);
}

TEST(AccuracySweep, DrawsALineAnEngineThatHeldAndTheGoal)
{
    const auto chart = AccuracyChart(TwoEngines());
    ASSERT_TRUE(chart);
    ASSERT_EQ(chart->lines.size(), 3u);
    EXPECT_EQ(chart->lines[0].series.name, "ours");
    EXPECT_GT(chart->lines[0].points.back().y, 0.0) << "a logarithm has no zero";
    EXPECT_EQ(chart->lines[1].points.size(), 1u);
    EXPECT_EQ(chart->lines[2].series.name, "goal");
    AccuracyResult burst = TwoEngines();
    burst.runs = {burst.runs.back()};
    EXPECT_FALSE(AccuracyChart(burst));
}

TEST(AccuracySweep, TellsInTableAndJsonWhatBurst)
{
    EXPECT_THAT(AccuracyTable({TwoEngines()}), HasSubstr("not finite"));
    EXPECT_THAT(AccuracyTable({TwoEngines()}), HasSubstr("goal met"));
    AccuracyResult result = TwoEngines();
    result.runs.back().error = kNoValue;
    EXPECT_THAT(AccuracyJson({result}), HasSubstr("\"error\": null"));
}

} // namespace
} // namespace boxreel
