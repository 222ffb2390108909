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

struct BenchScene
{
    std::string name;
    std::string what; ///< in a few words
};

/// What one engine took for a scene. Times in seconds, of a step or of what the scene does instead.
struct BenchFigures
{
    std::string engine;
    double mean = 0.0, median = 0.0, p99 = 0.0;
    double cpu = 0.0; ///< of the whole process, on average
    double contacts = 0.0;
    double memory = 0.0; ///< growth of the process [kB]
    bool finite = true;
    double escaped = 0.0;    ///< bodies that left the scene's bounds
    double meanHeight = 0.0; ///< of the dynamic bodies at the end [m]
    std::string failure;     ///< why there are no figures; empty: there are
    std::string verdict;     ///< "sound", or what is wrong in a few words
};

/// One scene, our engine first.
struct BenchResult
{
    BenchScene scene;
    std::vector<BenchFigures> engines;
};

/// The programs found beside this one, ours first; empty when the benchmark was not built.
std::vector<std::filesystem::path> FindBenchPrograms();

Result<std::vector<BenchScene>> ListBenchScenes(const std::filesystem::path& program);

/// Every engine `rounds` times in turn; each figure is the median of the rounds.
BenchResult RunBenchScene(const std::vector<std::filesystem::path>& programs,
                          const BenchScene& scene, int rounds);

/// One engine's line of JSON as figures.
Result<BenchFigures> ParseFigures(const std::string& output);

/// The median of each number.
BenchFigures MedianOf(const std::vector<BenchFigures>& rounds);

/// Fills the verdicts: nothing that is not finite, nobody escaped, and for our engine contacts and
/// heights like those of the others.
void Judge(std::vector<BenchFigures>& engines);

/// How many times less CPU time ours takes than the other; 0 when that cannot be said.
double RatioTo(const BenchFigures& ours, const BenchFigures& other);

/// A table for people, a row an engine.
std::string BenchTable(const std::vector<BenchResult>& results);
/// All figures and ratios for programs.
std::string BenchJson(const std::vector<BenchResult>& results);

} // namespace boxreel
