// SPDX-License-Identifier: MIT
#include "Benchmark.h"

#include "ChildProcess.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <unistd.h>

namespace boxreel
{
namespace
{

std::filesystem::path FolderOfThisProgram()
{
    std::error_code failure;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failure);
    return failure ? std::filesystem::path() : self.parent_path();
}

/// How far our contacts, heights and speeds may lie outside those of the peers: scenes are chaotic,
/// and engines keep different gaps. Over runs whose bodies begin up to 1 mm elsewhere the standard
/// deviation of the mean height during the second half is 1 to 1.4 % in the tumbler, 0.7 to 1 %
/// with the ragdolls, 0.2 % in the rain, for Box2D 2.4 as for ours.
constexpr double kContactsShare = 0.15;
constexpr double kContactsLeastInFlight = 10.0; // few of what flies about touch at a time
constexpr double kHeightShare = 0.03;
constexpr double kHeightLeast = 0.005; // m
constexpr double kSpeedShare = 0.05;
constexpr double kSpeedLeast = 0.1; // m/s

/// What calls find does not depend on chaos, only on rounding: a ray may just miss a corner.
constexpr double kFoundShare = 1e-4;

/// How much deeper our bodies may overlap than those of Box2D 2.4, which keeps the same skins and
/// leaves the same slop; others mean other things by an overlap. From run to run it varies by 3 %.
/// The most that a sound run of ours has more is 22 %, in the pyramid of base 100: that drifts
/// sideways by 0.4 m in Box2D, by 1 cm in ours, and has more contacts in ours.
constexpr double kOverlapShare = 0.25;
constexpr double kOverlapLeast = 0.001; // m

/// Whether ours is within a share of what the peers reach, or within a least distance.
bool IsLike(const std::vector<const BenchFigures*>& peers, const BenchFigures& ours,
            double BenchFigures::*number, double share, double least)
{
    double low = peers.front()->*number, high = low;
    for (const BenchFigures* peer : peers)
    {
        low = std::min(low, peer->*number);
        high = std::max(high, peer->*number);
    }
    const double value = ours.*number;
    return value >= low - std::max(least, share * std::abs(low)) &&
           value <= high + std::max(least, share * std::abs(high));
}

bool IsDeeper(const std::vector<const BenchFigures*>& peers, const BenchFigures& ours)
{
    return std::any_of(peers.begin(), peers.end(), [&ours](const BenchFigures* peer) {
        const double more = std::max(kOverlapLeast, kOverlapShare * peer->overlap);
        return IsGoalPeer(peer->engine) && ours.overlap > peer->overlap + more;
    });
}

std::string CountText(double count)
{
    return std::to_string(std::lround(count));
}

std::string JudgeAlone(const BenchFigures& figures)
{
    if (!figures.failure.empty())
    {
        return figures.failure;
    }
    if (!figures.finite)
    {
        return "not finite";
    }
    if (figures.escaped > 0.0)
    {
        return CountText(figures.escaped) + " escaped";
    }
    return figures.awake > 0.0 ? CountText(figures.awake) + " awake" : "sound";
}

/// What is wrong with ours beside the peers; empty: nothing.
std::string JudgeBeside(const BenchScene& scene, const BenchFigures& ours,
                        const std::vector<const BenchFigures*>& peers)
{
    if (peers.empty())
    {
        return "";
    }
    if (!IsLike(peers, ours, &BenchFigures::bodies, 0.0, 0.0))
    {
        return "other bodies";
    }
    if (!IsLike(peers, ours, &BenchFigures::found, kFoundShare, 0.0) ||
        !IsLike(peers, ours, &BenchFigures::foundSum, kFoundShare, 0.0))
    {
        return "other " + scene.found;
    }
    // A share of few contacts is less than one: there ours have to be exactly the peers'.
    const double contactsLeast = scene.comparesSpeeds ? kContactsLeastInFlight : 0.0;
    if (!IsLike(peers, ours, &BenchFigures::contacts, kContactsShare, contactsLeast))
    {
        return "other contacts";
    }
    if (!scene.comparesSpeeds && IsDeeper(peers, ours))
    {
        return "deep overlaps";
    }
    if (scene.comparesSpeeds)
    {
        return IsLike(peers, ours, &BenchFigures::meanSpeed, kSpeedShare, kSpeedLeast)
                   ? ""
                   : "other speeds";
    }
    return IsLike(peers, ours, &BenchFigures::meanHeight, kHeightShare, kHeightLeast)
               ? ""
               : "other heights";
}

BenchFigures RunOnce(const std::filesystem::path& program, const std::string& scene, int threads)
{
    const Result<std::string> output = OutputOf(program, {"run", scene, std::to_string(threads)});
    const Result<BenchFigures> figures =
        output ? ParseFigures(*output) : Result<BenchFigures>(output.GetError());
    if (figures)
    {
        return *figures;
    }
    BenchFigures failed;
    failed.engine = program.filename().string();
    failed.threads = threads;
    failed.failure = "failed";
    return failed;
}

} // namespace

std::vector<std::filesystem::path> FindPrograms(const std::vector<std::string>& names)
{
    const std::filesystem::path folder = FolderOfThisProgram() / "tests" / "benchmark";
    std::vector<std::filesystem::path> programs;
    for (const std::string& name : names)
    {
        const std::filesystem::path program = folder / name;
        if (access(program.c_str(), X_OK) == 0)
        {
            programs.push_back(program);
        }
        else if (programs.empty())
        {
            return {}; // without ours there is nothing to compare
        }
    }
    return programs;
}

std::vector<std::filesystem::path> FindBenchPrograms()
{
    return FindPrograms({"boxreel_bench", "boxreel_bench_box2d", "boxreel_bench_chipmunk"});
}

Result<std::vector<BenchScene>> ListBenchScenes(const std::filesystem::path& program)
{
    const Result<std::string> output = OutputOf(program, {"list"});
    if (!output)
    {
        return output.GetError();
    }
    std::vector<BenchScene> scenes;
    std::istringstream lines(*output);
    for (std::string line; std::getline(lines, line);)
    {
        scenes.push_back(ParseBenchScene(line));
    }
    return scenes;
}

BenchScene ParseBenchScene(const std::string& line)
{
    BenchScene scene;
    std::istringstream fields(line);
    std::getline(fields, scene.name, '\t');
    std::getline(fields, scene.what, '\t');
    for (std::string word; fields >> word;)
    {
        const std::size_t at = std::min(word.find('='), word.size());
        const std::string key = word.substr(0, at);
        const std::string value = word.substr(std::min(at + 1, word.size()));
        const double number = std::strtod(value.c_str(), nullptr);
        scene.goalTimesFaster = key == "faster" ? number : scene.goalTimesFaster;
        scene.goalSeconds = key == "seconds" ? number : scene.goalSeconds;
        scene.goalSpeedUp = key == "speed-up" ? number : scene.goalSpeedUp;
        scene.goalMemory = key == "memory" ? number : scene.goalMemory;
        scene.count = key == "count" ? number : scene.count;
        scene.onlyForCurve = scene.onlyForCurve || key == "only-curve";
        scene.curve = key == "curve" || key == "only-curve" ? value : scene.curve;
        scene.found = key == "found" ? value : scene.found;
        scene.comparesSpeeds = scene.comparesSpeeds || word == "like=speeds";
    }
    return scene;
}

double Median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

BenchFigures MedianOf(const std::vector<BenchFigures>& rounds)
{
    BenchFigures result = rounds.front();
    for (double BenchFigures::*number :
         {&BenchFigures::mean, &BenchFigures::median, &BenchFigures::p99, &BenchFigures::cpu,
          &BenchFigures::contacts, &BenchFigures::memory, &BenchFigures::escaped,
          &BenchFigures::awake, &BenchFigures::overlap, &BenchFigures::meanHeight,
          &BenchFigures::meanSpeed, &BenchFigures::bodies, &BenchFigures::found,
          &BenchFigures::foundSum})
    {
        std::vector<double> values;
        for (const BenchFigures& round : rounds)
        {
            if (std::isfinite(round.*number))
            {
                values.push_back(round.*number);
            }
        }
        result.*number = values.empty() ? std::nan("") : Median(std::move(values));
    }
    for (const BenchFigures& round : rounds)
    {
        result.finite = result.finite && round.finite;
        result.failure = result.failure.empty() ? round.failure : result.failure;
        result.bits = result.bits == round.bits ? result.bits : "vary";
    }
    return result;
}

BenchResult RunBenchScene(const std::vector<std::filesystem::path>& programs,
                          const BenchScene& scene, const BenchPlan& plan)
{
    struct Entry
    {
        std::filesystem::path program;
        int threads;
        std::vector<BenchFigures> rounds;
    };
    std::vector<Entry> entries;
    for (const int threads : plan.threads)
    {
        entries.push_back({programs.front(), threads, {}});
    }
    for (std::size_t i = 1; i < programs.size(); ++i)
    {
        entries.push_back({programs[i], 1, {}});
    }
    for (int round = 0; round < plan.rounds; ++round)
    {
        for (Entry& entry : entries)
        {
            entry.rounds.push_back(RunOnce(entry.program, scene.name, entry.threads));
        }
    }
    BenchResult result{scene, {}};
    for (const Entry& entry : entries)
    {
        result.engines.push_back(MedianOf(entry.rounds));
        result.engines.back().isOurs = result.engines.size() <= plan.threads.size();
    }
    Judge(result);
    return result;
}

void Judge(BenchResult& result)
{
    std::vector<const BenchFigures*> peers;
    for (BenchFigures& engine : result.engines)
    {
        engine.verdict = JudgeAlone(engine);
        if (!engine.isOurs && engine.verdict == "sound")
        {
            peers.push_back(&engine);
        }
    }
    for (BenchFigures& ours : result.engines)
    {
        if (!ours.isOurs || ours.verdict != "sound")
        {
            continue;
        }
        const bool sameBits = ours.bits != "vary" && ours.bits == result.engines.front().bits;
        const std::string beside = JudgeBeside(result.scene, ours, peers);
        ours.verdict = !sameBits ? "other bits" : beside.empty() ? "sound" : beside;
    }
}

bool IsComparable(const BenchFigures& figures)
{
    return figures.failure.empty() && figures.finite && figures.escaped == 0.0 &&
           figures.awake == 0.0;
}

double CpuRatio(const BenchFigures& ours, const BenchFigures& other)
{
    return IsComparable(ours) && IsComparable(other) && ours.cpu > 0.0 ? other.cpu / ours.cpu : 0.0;
}

double WallRatio(const BenchFigures& ours, const BenchFigures& other)
{
    return IsComparable(ours) && IsComparable(other) && ours.mean > 0.0 ? other.mean / ours.mean
                                                                        : 0.0;
}

double SpeedUp(const BenchResult& result, const BenchFigures& figures)
{
    const auto one = std::find_if(result.engines.begin(), result.engines.end(),
                                  [](const BenchFigures& e) { return e.isOurs && e.threads == 1; });
    const bool known = figures.isOurs && figures.threads > 1 && one != result.engines.end();
    return known ? WallRatio(figures, *one) : 0.0;
}

double SpeedUpGoal(const BenchScene& scene, const BenchFigures& figures)
{
    return figures.isOurs && figures.threads == 2 ? scene.goalSpeedUp : 0.0;
}

double MemoryGoal(const BenchScene& scene, const BenchFigures& figures)
{
    return figures.isOurs ? scene.goalMemory : 0.0;
}

bool IsLikePeers(const BenchFigures& ours)
{
    return ours.verdict == "sound";
}

bool IsGoalPeer(const std::string& engine)
{
    return engine.rfind("Box2D 2.4", 0) == 0;
}

} // namespace boxreel
