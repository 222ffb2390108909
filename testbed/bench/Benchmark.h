// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Runs the benchmark programs of the engines in turn and compares what they measured. The programs
/// are built beside this one, from tests/benchmark; they are executed, never linked.
namespace boxreel
{

/// A scene, and what its figures are held against.
struct BenchScene
{
    std::string name;
    std::string what;             ///< in a few words
    double goalTimesFaster = 0.0; ///< than Box2D 2.4; 0: no such goal
    double goalSeconds = 0.0;     ///< CPU time of a step; 0: no such goal
    double goalSpeedUp = 0.0;     ///< of two threads of ours over one; 0: no such goal
    double goalMemory = 0.0;      ///< growth of our process at most [kB]; 0: no such goal
    std::string curve;            ///< scenes of one curve differ only in `count`; empty: none
    double count = 0.0;
    bool onlyForCurve = false;   ///< run for the curve or when named, else not
    std::string found;           ///< what its calls find and count, one word; empty: nothing
    bool comparesSpeeds = false; ///< the bodies' mean speed tells a sound run, not their height
};

/// What one engine took for a scene. Times in seconds, of a step or of what the scene does instead.
struct BenchFigures
{
    std::string engine; ///< name and version
    bool isOurs = false;
    int threads = 1;
    double mean = 0.0, median = 0.0, p99 = 0.0; ///< wall time
    double cpu = 0.0;                           ///< of the whole process, on average
    double contacts = 0.0;                      ///< NaN: nobody counted, for the world burst before
    double memory = 0.0;                        ///< growth of the process [kB]
    bool finite = true;
    double escaped = 0.0;    ///< bodies that left the scene's bounds
    double awake = 0.0;      ///< bodies that should sleep and do not
    double overlap = 0.0;    ///< root mean square, in the run's second half [m]
    double meanHeight = 0.0; ///< of the dynamic bodies, in the run's second half [m]
    double meanSpeed = 0.0;  ///< of the dynamic bodies, in the run's second half [m/s]
    double bodies = 0.0;     ///< in the world at the end
    double found = 0.0;      ///< count of what the scene's calls find, such as hits of rays
    double foundSum = 0.0;   ///< sum over these, such as fractions: the same in every engine
    std::string bits;        ///< of all bodies at the end, hashed; "vary": not the same every time
    std::string failure;     ///< why there are no figures; empty: there are
    std::string verdict;     ///< "sound", or what is wrong in a few words
};

/// One scene, our engine first: what all others are compared with. With several thread counts it
/// comes once for each, in the order asked for, before the peers.
struct BenchResult
{
    BenchScene scene;
    std::vector<BenchFigures> engines;
};

struct BenchPlan
{
    int rounds = 3;
    std::vector<int> threads{1}; ///< of our engine; the peers have one
};

/// The programs found beside this one, ours first; empty when the benchmark was not built.
std::vector<std::filesystem::path> FindBenchPrograms();
/// Those of these names that are there; none without the first.
std::vector<std::filesystem::path> FindPrograms(const std::vector<std::string>& names);

Result<std::vector<BenchScene>> ListBenchScenes(const std::filesystem::path& program);

/// Every engine and thread count `rounds` times in turn; each figure is the median of the rounds.
BenchResult RunBenchScene(const std::vector<std::filesystem::path>& programs,
                          const BenchScene& scene, const BenchPlan& plan);

/// One line of a program's list.
BenchScene ParseBenchScene(const std::string& line);

/// One engine's line of JSON as figures.
Result<BenchFigures> ParseFigures(const std::string& output);

/// The middle one, or the mean of the middle two; `values` is not empty.
double Median(std::vector<double> values);
/// The median of each number.
BenchFigures MedianOf(const std::vector<BenchFigures>& rounds);

/// Fills the verdicts: nothing that is not finite, nobody escaped or awake, and for our engine
/// bodies, contacts, what calls find, and heights or speeds, like those of the sound peers,
/// overlaps not deeper than those of Box2D 2.4, and the same bits whenever it runs, at every thread
/// count.
void Judge(BenchResult& result);

/// Whether there are figures, of a world that did not burst: others are not compared.
bool IsComparable(const BenchFigures& figures);

/// How many times less CPU time, or wall time, ours takes than the other; 0 when they cannot be
/// compared.
double CpuRatio(const BenchFigures& ours, const BenchFigures& other);
double WallRatio(const BenchFigures& ours, const BenchFigures& other);

/// The wall time of one thread of ours over that of these threads of ours; 0 where there is nothing
/// to compare.
double SpeedUp(const BenchResult& result, const BenchFigures& figures);

/// The goals of this row: of ours, and the speed-up of two threads; 0: none.
double SpeedUpGoal(const BenchScene& scene, const BenchFigures& figures);
double MemoryGoal(const BenchScene& scene, const BenchFigures& figures);

/// Whether ours ended like the sound peers, as Judge found: if not, a ratio is no gain, and is
/// shown in brackets only.
bool IsLikePeers(const BenchFigures& ours);

/// Whether goals are against this engine.
bool IsGoalPeer(const std::string& engine);

/// A table for people, a row an engine; ratios in brackets where ours is not like the peers.
std::string BenchTable(const std::vector<BenchResult>& results);
/// All figures and ratios for programs.
std::string BenchJson(const std::vector<BenchResult>& results);
/// What BenchJson wrote, without the ratios. `name` is for the error's sentence.
Result<std::vector<BenchResult>> ParseBenchJson(const std::string& text, const std::string& name);

/// 7.26 ms, 350 us: three digits and a unit that fits.
std::string TimeText(double seconds);
/// 2.61x, 31.4x, 12,300x: three digits, so that 6.95 does not read like a goal of 7; empty for 0.
std::string RatioText(double ratio);

} // namespace boxreel
