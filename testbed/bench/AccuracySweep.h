// SPDX-License-Identifier: MIT
#pragma once

#include "Chart.h"

#include <debugdraw/Result.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Runs the accuracy cases of the engines' programs over a sweep of settings and shows CPU time
/// against error: as a table, as JSON, and as a chart a case. The programs (tests/benchmark) are
/// executed, never linked.
namespace boxreel
{

struct AccuracySettings
{
    int velocityIterations = 8;
    int positionIterations = 3;
    int hz = 60;
    int subSteps = 1;
};

/// What the engine makes of the iterations of a step for each sub-step, as its program says.
struct SubStepIterations
{
    int velocity = 0; ///< 0: not said
    int position = 0; ///< 0: none
};

/// What one of a run's further numbers has to be.
struct RemarkGoal
{
    std::string name;
    double bound = 0.0;
    bool isLeast = false; ///< at least the bound, else at most
};

struct AccuracyCase
{
    std::string name;
    std::string what;  ///< in a few words
    std::string unit;  ///< of the error
    double goal = 0.0; ///< the largest error that is good enough, in that unit
    int mostSubSteps = 1;
    std::vector<RemarkGoal> remarkGoals{}; ///< besides
};

struct AccuracyFigures
{
    std::string engine; ///< name and version
    AccuracySettings settings;
    SubStepIterations each;
    double error = kNoValue; ///< kNoValue: there is none
    double cpu = 0.0;        ///< of a step [s]
    int steps = 0;           ///< that the run took: fewer than it should when it broke; 0: not said
    bool held = false;       ///< all numbers stayed finite
    std::string ending;      ///< "falls", "bursts": what no error tells; empty: as it should
    std::vector<std::pair<std::string, double>> remarks; ///< more numbers, units in their names
    std::string failure; ///< why there are no figures; empty: there are

    /// For a sixtieth of a second, however many steps that takes: what settings are compared by
    /// [s].
    double CpuOfAFrame() const { return cpu * settings.hz / 60.0; }
};

struct AccuracyResult
{
    AccuracyCase info;
    std::vector<AccuracyFigures> runs;
};

/// One line of a program's `accuracy-list`.
AccuracyCase ParseAccuracyCase(const std::string& line);
/// The line of JSON that `accuracy` prints, whatever stands before it.
Result<AccuracyFigures> ParseAccuracyFigures(const std::string& output);
/// The CPU time of a step, where nothing else was to be looked at [s].
Result<double> ParseAccuracyTime(const std::string& output);

/// The cases of one program, with the sub-steps of its engine.
Result<std::vector<AccuracyCase>> ListAccuracyCases(const std::filesystem::path& program);

/// Iterations 4/2, 8/3, 20/10 and 50/20, each at 60, 120, 240 and 480 Hz, each with 1, 2, 4, 8 and
/// 16 sub-steps as far as the engine has them.
std::vector<AccuracySettings> AccuracySweep(int mostSubSteps);

/// All settings of all engines: each in turn, `rounds` times, engine by engine within a round. The
/// error is that of the first, for all are the same; the CPU time is the least, for what makes the
/// others longer is the machine's, which may have slow spells longer than a run. What takes long
/// by itself is timed once.
Result<AccuracyResult> RunAccuracySweep(const std::vector<std::filesystem::path>& programs,
                                        const AccuracyCase& info, int rounds);

/// Whether the run ended as it should with numbers for everything.
bool HasFigures(const AccuracyFigures& run);
/// Which further numbers of the run are not what the case asks for, as "gap_mm 0.3, at most 0.1";
/// empty: none.
std::string MissedRemarks(const AccuracyCase& info, const AccuracyFigures& run);
/// Whether the run meets all goals of the case.
bool MeetsGoals(const AccuracyCase& info, const AccuracyFigures& run);

/// By their names, in the order in which they first come.
std::vector<std::string> EnginesOf(const AccuracyResult& result);
/// 8 and 3 iterations at 60 Hz, with so many sub-steps when the engine was run with any.
AccuracySettings UsualSettings(const AccuracyResult& result, const std::string& engine,
                               int subSteps = 4);

/// A row a run, and the summary.
std::string AccuracyTable(const std::vector<AccuracyResult>& results);
/// A row a case: what every engine reaches with its usual settings. `results` is not empty.
std::string AccuracySummary(const std::vector<AccuracyResult>& results);
/// All figures for programs.
std::string AccuracyJson(const std::vector<AccuracyResult>& results);
/// What AccuracyJson wrote. `name` is for the error's sentence.
Result<std::vector<AccuracyResult>> ParseAccuracyJson(const std::string& text,
                                                      const std::string& name);
/// A curve for each engine and each thing that varies, in CPU time and error, and the goal. An
/// Error when nothing has held.
Result<LineChart> AccuracyChart(const AccuracyResult& result);

} // namespace boxreel
