// SPDX-License-Identifier: MIT
#include "Subprocess.h"

#include <bench/AccuracySweep.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace boxreel
{
namespace
{

using testing::HasSubstr;

constexpr const char* kLine =
    R"({"engine":"Box2D 2.4.1","case":"A-projectile","velocityIterations":20,"positionIterations":10,)"
    R"("hz":240,"subSteps":2,"velocityIterationsOfASubStep":10,"positionIterationsOfASubStep":5,)"
    R"("error":0.04,"unit":"m","steps":480,"cpu":1e-06,"held":true,"ending":"falls",)"
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
    EXPECT_EQ(figures->each.velocity, 10);
    EXPECT_EQ(figures->each.position, 5);
    EXPECT_EQ(figures->error, 0.04);
    EXPECT_EQ(figures->ending, "falls");
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

/// 8/3 at 60 Hz, and what differs.
AccuracyFigures Setting(const char* engine, int velocity, int hz, int subSteps, double error)
{
    AccuracyFigures run = Run(engine, 1e-6 * subSteps, error);
    run.settings = {velocity, velocity == 8 ? 3 : 10, hz, subSteps};
    run.each = {std::max(1, velocity / subSteps), 1};
    return run;
}

/// Two engines, one of them with sub-steps, whose curves meet in the usual settings.
AccuracyResult TwoSweeps()
{
    AccuracyResult result{ParseAccuracyCase("A-projectile\tthrown\tunit=m goal=0.01 sub-steps=4"),
                          {}};
    result.runs = {Setting("ours", 8, 60, 1, 0.1),         Setting("ours", 8, 60, 4, 0.0),
                   Setting("ours", 8, 120, 4, 0.0),        Setting("ours", 20, 60, 4, 0.0),
                   Setting("ours", 20, 120, 1, 0.3),       Setting("Box2D 2.4.1", 8, 60, 1, 0.2),
                   Setting("Box2D 2.4.1", 8, 120, 1, 0.1), Setting("Box2D 2.4.1", 20, 60, 1, 0.2)};
    return result;
}

/// A program that says it takes `subSteps` and needs these seconds a step, a figure for each time
/// that it is run with one setting; it writes down how it was run.
std::filesystem::path Program(const std::filesystem::path& folder, const std::string& name,
                              int subSteps, const std::string& seconds)
{
    std::filesystem::path program = folder / name;
    std::ofstream(program)
        << "#!/bin/sh\n"
           "cd '"
        << folder.string()
        << "'\n"
           "if [ $1 = accuracy-list ]; then\n"
           "printf 'A\\twhat\\tunit=m goal=1 sub-steps="
        << subSteps
        << "\\n'\n"
           "exit; fi\n"
           "echo \""
        << name
        << " $*\" >> runs\n"
           "n=$(grep -c \""
        << name
        << " accuracy $2 $3 $4 $5 $6\\( \\|$\\)\" runs)\n"
           "cpu=$(echo '"
        << seconds
        << "' | cut -d ' ' -f $n)\n"
           "[ $# = 7 ] && echo \"{\\\"cpu\\\":$cpu}\" && exit\n"
           "echo \"{\\\"engine\\\":\\\""
        << name
        << "\\\",\\\"hz\\\":$5,\\\"subSteps\\\":$6,"
           "\\\"velocityIterations\\\":$3,\\\"positionIterations\\\":$4,"
           "\\\"error\\\":0.5,\\\"steps\\\":70,\\\"cpu\\\":$cpu,\\\"held\\\":true}\"\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return program;
}

std::vector<std::string> LinesOf(const std::filesystem::path& file)
{
    std::vector<std::string> lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

TEST(AccuracySweep, RunsAllEnginesInTurnAndKeepsTheLeastTimeOfTheRounds)
{
    const TemporaryFolder folder;
    const std::filesystem::path ours = Program(folder.Path(), "ours", 2, "3e-6 1e-6 2e-6");
    const std::filesystem::path peer = Program(folder.Path(), "peer", 1, "5e-6 6e-6 7e-6");
    const auto result = RunAccuracySweep({ours, peer}, ParseAccuracyCase("A\twhat\tunit=m"), 3);
    ASSERT_TRUE(result) << result.GetError().message;
    ASSERT_EQ(result->runs.size(), 48u);
    for (const AccuracyFigures& run : result->runs)
    {
        EXPECT_EQ(run.failure, "");
        EXPECT_EQ(run.error, 0.5);
        EXPECT_EQ(run.cpu, run.engine == "ours" ? 1e-6 : 5e-6);
    }
    EXPECT_EQ(result->runs[31].engine, "ours") << "together, though they ran in turn";
    EXPECT_EQ(result->runs[32].engine, "peer");
    const std::vector<std::string> lines = LinesOf(folder / "runs");
    ASSERT_EQ(lines.size(), 144u);
    EXPECT_EQ(lines[0], "ours accuracy A 4 2 60 1");
    EXPECT_EQ(lines[1], "peer accuracy A 4 2 60 1");
    EXPECT_EQ(lines[2], "ours accuracy A 4 2 60 2");
    EXPECT_EQ(lines[3], "peer accuracy A 4 2 120 1");
    EXPECT_EQ(lines[48], "ours accuracy A 4 2 60 1 70") << "as many steps as the run had";
    EXPECT_EQ(lines[97], "peer accuracy A 4 2 60 1 70");
}

TEST(AccuracySweep, TimesWhatTakesLongOnce)
{
    const TemporaryFolder folder;
    const std::filesystem::path slow = Program(folder.Path(), "slow", 1, "1 1");
    ASSERT_TRUE(RunAccuracySweep({slow}, ParseAccuracyCase("A\twhat\tunit=m"), 2));
    EXPECT_EQ(LinesOf(folder / "runs").size(), 16u);
}

TEST(AccuracySweep, FailsWhereAProgramFailsInAnyRound)
{
    const TemporaryFolder folder;
    const std::filesystem::path once = Program(folder.Path(), "once", 1, "1e-6 none");
    const auto result = RunAccuracySweep({once}, ParseAccuracyCase("A\twhat\tunit=m"), 2);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->runs[0].failure, "failed");
}

TEST(AccuracySweep, DrawsACurveForEachEngineAndEachThingThatVaries)
{
    const auto chart = AccuracyChart(TwoSweeps());
    ASSERT_TRUE(chart);
    std::vector<std::pair<std::string, ChartStroke>> curves;
    for (const ChartLine& line : chart->lines)
    {
        curves.emplace_back(line.series.name, line.series.stroke);
    }
    EXPECT_THAT(curves, testing::ElementsAre(testing::Pair("ours", ChartStroke::Solid),
                                             testing::Pair("ours", ChartStroke::Dashed),
                                             testing::Pair("ours", ChartStroke::Dotted),
                                             testing::Pair("Box2D 2.4.1", ChartStroke::Dashed),
                                             testing::Pair("Box2D 2.4.1", ChartStroke::Dotted),
                                             testing::Pair("ours", ChartStroke::None),
                                             testing::Pair("Box2D 2.4.1", ChartStroke::None)));
    const std::vector<ChartPoint>& small = chart->lines[0].points;
    ASSERT_EQ(small.size(), 2u);
    EXPECT_EQ(small[0].label, "1");
    EXPECT_EQ(small[1].label, "4 sub-steps");
    EXPECT_EQ(small[1].mark, ChartMark::Ring) << "the usual settings";
    EXPECT_EQ(small[1].y, chart->floor) << "a logarithm has no zero";
    EXPECT_EQ(chart->lines[1].points[0].mark, ChartMark::Disc) << "one ring is enough";
    EXPECT_EQ(chart->lines[1].points[1].label, "120 Hz");
    ASSERT_EQ(chart->lines[5].points.size(), 1u);
    EXPECT_EQ(chart->lines[5].points[0].mark, ChartMark::Speck);
}

TEST(AccuracySweep, DrawsTheGoalAndTheTimeOfTheGoalsPeer)
{
    const auto chart = AccuracyChart(TwoSweeps());
    ASSERT_TRUE(chart);
    ASSERT_EQ(chart->rules.size(), 2u);
    EXPECT_EQ(chart->rules[0].value, 0.01);
    EXPECT_EQ(chart->rules[0].label, "goal: 0.01 m");
    EXPECT_TRUE(chart->rules[1].upright);
    EXPECT_DOUBLE_EQ(chart->rules[1].value, 1.0) << "[us]";
    AccuracyResult alone = TwoSweeps();
    alone.runs.resize(5);
    EXPECT_EQ(AccuracyChart(alone)->rules.size(), 1u);
}

TEST(AccuracySweep, CrossesOutWhatFailed)
{
    AccuracyResult result = TwoSweeps();
    result.runs[6].ending = "falls";
    result.runs[7].held = false;
    const auto chart = AccuracyChart(result);
    ASSERT_TRUE(chart);
    EXPECT_EQ(chart->lines[3].points[1].mark, ChartMark::Cross);
    EXPECT_EQ(chart->lines[3].points[1].y, 0.1);
    EXPECT_EQ(chart->lines[4].points[1].mark, ChartMark::Cross);
    EXPECT_TRUE(std::isnan(chart->lines[4].points[1].y));
    for (AccuracyFigures& run : result.runs)
    {
        run.held = false;
    }
    EXPECT_FALSE(AccuracyChart(result)) << "nothing is left to draw";
}

TEST(AccuracySweep, CrossesOutWhatFellOffTheCurves)
{
    AccuracyResult result = TwoSweeps();
    result.runs[4].ending = "falls";
    EXPECT_EQ(AccuracyChart(result)->lines[5].points[0].mark, ChartMark::Cross);
}

TEST(AccuracySweep, DrawsTheOnlyRunOfAnEngine)
{
    AccuracyResult result = TwoSweeps();
    result.runs.push_back(Setting("alone", 8, 60, 1, 0.3));
    const auto chart = AccuracyChart(result);
    ASSERT_TRUE(chart);
    EXPECT_EQ(chart->lines.back().series.name, "alone");
    ASSERT_EQ(chart->lines.back().points.size(), 1u);
    EXPECT_EQ(chart->lines.back().points[0].mark, ChartMark::Ring);
    EXPECT_EQ(chart->lines.back().points[0].y, 0.3);
}

/// Walls within which ours has kept so much of the energy.
AccuracyResult WallsThatKeep(double percent)
{
    AccuracyResult result{
        ParseAccuracyCase("X-walls\tin walls\tunit=bodies goal=0 sub-steps=4 kept_percent>=98"),
        {}};
    result.runs = {Setting("ours", 8, 60, 1, 0.0), Setting("ours", 8, 60, 4, 0.0)};
    result.runs[0].remarks = {{"kept_percent", 8.5}};
    result.runs[1].remarks = {{"kept_percent", percent}};
    return result;
}

TEST(AccuracySweep, JudgesAllGoalsOfACase)
{
    const AccuracyResult met = WallsThatKeep(98.0), missed = WallsThatKeep(70.0);
    EXPECT_TRUE(MeetsGoals(met.info, met.runs[1]));
    EXPECT_FALSE(MeetsGoals(met.info, met.runs[0]));
    EXPECT_FALSE(MeetsGoals(missed.info, missed.runs[1]));
    EXPECT_THAT(AccuracyTable({met}), HasSubstr("  kept_percent 8.5, at least 98\n"));
    EXPECT_THAT(AccuracySummary({met}), HasSubstr("  goal met\n"));
    EXPECT_THAT(AccuracySummary({missed}),
                HasSubstr("  goal not met: kept_percent 70, at least 98\n"));
    AccuracyResult unknown = met;
    unknown.runs[1].remarks.clear();
    EXPECT_THAT(AccuracySummary({unknown}), HasSubstr("goal not met: kept_percent unknown"));
    const auto again = ParseAccuracyJson(AccuracyJson({missed}), "a.json");
    ASSERT_TRUE(again);
    EXPECT_EQ(AccuracySummary(*again), AccuracySummary({missed}));
    const auto chart = AccuracyChart(met);
    ASSERT_TRUE(chart);
    EXPECT_EQ(chart->lines[0].points[0].mark, ChartMark::Cross);
    EXPECT_EQ(chart->lines[0].points[1].mark, ChartMark::Ring);
    EXPECT_THAT(chart->frame.notes.back(), HasSubstr("kept at least 98 percent"));
}

TEST(AccuracySweep, RefusesNumbersThatCannotBe)
{
    const std::string text = AccuracyJson({WallsThatKeep(99.0)});
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        other.replace(other.find(from), from.size(), to);
        const auto result = ParseAccuracyJson(other, "a.json");
        return result ? std::string("none") : result.GetError().message;
    };
    EXPECT_EQ(with("\"goal\": 0.0", "\"goal\": 0.5"), "none");
    EXPECT_THAT(with("\"goal\": 0.0", "\"goal\": \"x\""),
                HasSubstr("'a.json' has a goal for 'X-walls' that is no number"));
    EXPECT_THAT(with("\"least\": 98.0", "\"least\": null"), HasSubstr("no number"));
    EXPECT_THAT(with("\"error\": 0.0", "\"error\": -5"),
                HasSubstr("'a.json' has 'error' of -5, which is no number from "));
    EXPECT_THAT(with("\"hz\": 60", "\"hz\": 0"), HasSubstr("is not what"));
    for (const char* field : {"velocityIterations", "positionIterations", "hz", "subSteps",
                              "velocityIterationsOfASubStep", "positionIterationsOfASubStep"})
    {
        const std::string name = "\"" + std::string(field) + "\": ";
        const std::size_t value = text.find(name) + name.size();
        const std::string whole =
            name + text.substr(value, text.find_first_of(",\n", value) - value);
        EXPECT_THAT(with(whole, name + "1000001"),
                    HasSubstr("has '" + std::string(field) + "' of 1e+06, which is no number"));
        EXPECT_THAT(with(whole, name + "1e300"), HasSubstr("which is no number from 1 to 1e+06"));
        EXPECT_THAT(with(whole, name + "\"x\""), HasSubstr("'a.json' has '" + std::string(field) +
                                                           "' in 'X-walls' that is no "));
    }
    EXPECT_EQ(with("\"error\": 0.0", "\"error\": null"), "none") << "there may be none";
    for (const char* error : {"\"x\"", "true", "[]", "{}"})
    {
        EXPECT_THAT(with("\"error\": 0.0", std::string("\"error\": ") + error),
                    HasSubstr("'a.json' has 'error' in 'X-walls' that is no number"));
    }
}

TEST(AccuracySweep, SumsUpWhatTheUsualSettingsReach)
{
    AccuracyResult result = TwoSweeps();
    EXPECT_THAT(AccuracySummary({result}), HasSubstr("0.25x  goal met, slower\n"));
    EXPECT_THAT(AccuracySummary({result}), HasSubstr("\n2 sub-steps "));
    result.runs[5].ending = "falls";
    result.runs[1].cpu = 1e-7;
    EXPECT_THAT(AccuracySummary({result}), HasSubstr("falls  1.00 us 10.00x  goal met\n"));
    result.runs[1].ending = "falls";
    EXPECT_THAT(AccuracySummary({result}), HasSubstr("goal not met"));
}

TEST(AccuracySweep, SaysWhatEachSubStepGets)
{
    AccuracyResult result = TwoSweeps();
    EXPECT_THAT(AccuracyTable({result}), HasSubstr("8/3         4       2/1"));
    result.runs[1].each = {10, 0};
    EXPECT_THAT(AccuracyTable({result}), HasSubstr("8/3         4        10"));
}

TEST(AccuracySweep, ReadsWhatItWrote)
{
    AccuracyResult result = TwoSweeps();
    result.runs[2].error = kNoValue;
    result.runs[3].ending = "falls";
    result.runs[4].remarks = {{"gap_mm", 0.25}};
    result.runs[6].failure = "failed";
    result.runs[6].each = {};
    const std::string text = AccuracyJson({result, result});
    const auto again = ParseAccuracyJson(text, "a.json");
    ASSERT_TRUE(again);
    EXPECT_EQ(AccuracyJson(*again), text);
    EXPECT_EQ(AccuracyTable(*again), AccuracyTable({result, result}));
    for (const char* other :
         {"", "{}", R"({"cases":[]})", R"({"cases":[{"case":"A","runs":[]}]})",
          R"({"cases":[{"case":"A","runs":[{"engine":"x","hz":0}]}]})", R"({"scenes":[]})"})
    {
        EXPECT_FALSE(ParseAccuracyJson(other, "a.json")) << other;
    }
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
