// SPDX-License-Identifier: MIT
#pragma once

#include "Chart.h"

#include <debugdraw/Result.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Compares pictures in which something was changed by several programs, and shows what each finds
/// and misses, and how long it takes. The peers are executed, never linked: odiff and pixelmatch
/// from a folder of npm's, ImageMagick's compare.
namespace boxreel
{

/// What a picture with this change is to be called.
enum class PlantedTruth
{
    Different,
    Equal,  ///< calling it different is a false alarm
    Either, ///< for its time only
};

struct PlantedKind
{
    std::string name;
    std::string what; ///< in a few words
    PlantedTruth truth = PlantedTruth::Different;
};

/// Each kind of change, in the order of the table.
const std::vector<PlantedKind>& PlantedKinds();

/// Two files, and the frames in them for what is timed without reading them.
struct PlantedPair
{
    std::size_t kind = 0; ///< index into PlantedKinds()
    std::filesystem::path expected;
    std::filesystem::path actual;
};

/// Of one pair, by one method.
struct PairVerdict
{
    bool isDifferent = false;
    double decoded = kNoValue; ///< comparing what was read before [s]
    double process = kNoValue; ///< from the start of a program to its end [s]
};

struct GoldenMethod
{
    std::string name; ///< with what it was told
    bool isOurs = false;
    std::vector<PairVerdict> verdicts; ///< one for each pair
    std::string failure;               ///< why there are none; empty: there are
};

struct GoldenBenchResult
{
    std::vector<std::string> scenes;
    std::vector<PlantedPair> pairs;
    std::vector<GoldenMethod> methods; ///< ours first
    std::vector<std::string> absent;   ///< peers, with what to install
};

/// Programs to compare with; empty where there is none.
struct GoldenPeers
{
    std::filesystem::path odiff;
    std::filesystem::path pixelmatch; ///< its package's folder
    std::string compare;
    std::string odiffVersion, pixelmatchVersion, compareVersion;
    std::vector<std::string> absent; ///< sentences
};

/// `folder`: where npm put odiff-bin and pixelmatch; empty: nowhere. An Error (Unusable) when
/// neither is there.
Result<GoldenPeers> FindGoldenPeers(const std::filesystem::path& folder);

/// What each present peer says of each pair, each `rounds` times; times are medians. `work` takes a
/// file. Stops early, with an Error, when `isStopped` says so.
Result<std::vector<GoldenMethod>> RunGoldenPeers(const GoldenPeers& peers,
                                                 const std::vector<PlantedPair>& pairs, int rounds,
                                                 const std::filesystem::path& work,
                                                 const std::function<bool()>& isStopped);

/// A program that ends with 0 for equal pictures and with `differentCode` for others. Fills the
/// verdicts' `isDifferent` and `process`.
struct PairProgram
{
    std::filesystem::path program;
    std::vector<std::string> before; ///< words before the two files …
    std::vector<std::string> after;  ///< … and after them
    int differentCode = 1;
};
Result<void> TimeProgram(const PairProgram& program, const std::vector<PlantedPair>& pairs,
                         int rounds, const std::function<bool()>& isStopped, GoldenMethod& method);

double MedianOf(std::vector<double> values);

/// A row a method, with what it found of each kind, and its times.
std::string GoldenTable(const GoldenBenchResult& result);
/// All figures for programs.
std::string GoldenJson(const GoldenBenchResult& result);

} // namespace boxreel
