// SPDX-License-Identifier: MIT
#include "Benchmark.h"
#include "Format.h"

#include "ChartScale.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

constexpr double kGoalOfP99 = 2.0; // times the median

/// How far the slowest steps are from the usual one, with a sign where that is beyond the goal.
std::string SpreadText(const BenchFigures& figures)
{
    const double spread = figures.median > 0.0 ? figures.p99 / figures.median : 0.0;
    return Format("%.2f", spread) + (spread > kGoalOfP99 ? "!" : " ");
}

std::string ContactsText(const BenchFigures& figures)
{
    return std::isfinite(figures.contacts) ? Format("%ld", std::lround(figures.contacts)) : "-";
}

std::string Head(bool withThreads)
{
    return Format("%-15s %-16s %s%9s %9s %9s %8s  %9s %9s %8s %8s %8s %9s  %7s  %s\n", "scene",
                  "engine", withThreads ? "threads speed-up   goal " : "", "mean", "median", "p99",
                  "/median", "CPU", "wall/ours", "CPU/ours", "goal", "contacts", "memory", "goal",
                  "verdict");
}

std::string GoalText(const BenchScene& scene, const BenchFigures& figures)
{
    if (figures.isOurs && scene.goalSeconds > 0.0)
    {
        return TimeText(scene.goalSeconds);
    }
    return IsGoalPeer(figures.engine) ? RatioText(scene.goalTimesFaster) : "";
}

/// Threads, what they win, with a sign where that is below the goal, and the goal.
std::string ThreadsText(const BenchResult& result, const BenchFigures& figures)
{
    const double speedUp = SpeedUp(result, figures);
    const double goal = SpeedUpGoal(result.scene, figures);
    const char sign = speedUp > 0.0 && speedUp < goal ? '!' : ' ';
    return Format("%7d %8s%c %5s ", figures.threads, RatioText(speedUp).c_str(), sign,
                  RatioText(goal).c_str());
}

/// The memory, with a sign where that is beyond the goal, and the goal.
std::string MemoryText(const BenchScene& scene, const BenchFigures& figures)
{
    const double goal = MemoryGoal(scene, figures);
    const char sign = goal > 0.0 && figures.memory > goal ? '!' : ' ';
    const std::string goalText = goal > 0.0 ? Format("%.1f MB", goal / 1024.0) : "";
    return Format("%6.1f MB%c %7s", figures.memory / 1024.0, sign, goalText.c_str());
}

/// Of a peer's row.
std::string PeerRatio(const BenchFigures& ours, double ratio)
{
    const std::string text = RatioText(ratio);
    return text.empty() || IsLikePeers(ours) ? text : "(" + text + ")";
}

std::string Row(const BenchResult& result, const BenchFigures& figures, bool withThreads)
{
    const BenchFigures& first = result.engines.front();
    const std::string scene = &figures == &first ? result.scene.name : "";
    const std::string threads = withThreads ? ThreadsText(result, figures) : "";
    if (!figures.failure.empty())
    {
        return Format("%-15s %-16s %s%s\n", scene.c_str(), figures.engine.c_str(), threads.c_str(),
                      figures.verdict.c_str());
    }
    const std::string wall = figures.isOurs ? "" : PeerRatio(first, WallRatio(first, figures));
    const std::string cpu = figures.isOurs ? "" : PeerRatio(first, CpuRatio(first, figures));
    return Format("%-15s %-16s %s%9s %9s %9s %9s %9s %9s %8s %8s %8s %s  %s\n", scene.c_str(),
                  figures.engine.c_str(), threads.c_str(), TimeText(figures.mean).c_str(),
                  TimeText(figures.median).c_str(), TimeText(figures.p99).c_str(),
                  SpreadText(figures).c_str(), TimeText(figures.cpu).c_str(), wall.c_str(),
                  cpu.c_str(), GoalText(result.scene, figures).c_str(),
                  ContactsText(figures).c_str(), MemoryText(result.scene, figures).c_str(),
                  figures.verdict.c_str());
}

bool HasThreads(const std::vector<BenchResult>& results)
{
    const auto hasMany = [](const BenchFigures& engine) { return engine.threads > 1; };
    return std::any_of(results.begin(), results.end(), [&](const BenchResult& result) {
        return std::any_of(result.engines.begin(), result.engines.end(), hasMany);
    });
}

/// What the largest of each curve's scenes takes against the smallest, an engine a line.
std::string GrowthLines(const std::vector<BenchResult>& results)
{
    std::string lines;
    for (const BenchResult& small : results)
    {
        const BenchResult* large = nullptr;
        bool isSmallest = !small.scene.curve.empty();
        for (const BenchResult& other : results)
        {
            const bool sameCurve = other.scene.curve == small.scene.curve;
            isSmallest = isSmallest && !(sameCurve && other.scene.count < small.scene.count);
            if (sameCurve && other.scene.count > (large ? large->scene.count : small.scene.count))
            {
                large = &other;
            }
        }
        const std::size_t engines =
            isSmallest && large ? std::min(small.engines.size(), large->engines.size()) : 0;
        for (std::size_t i = 0; i < engines; ++i)
        {
            if (i > 0 && small.engines[i].isOurs)
            {
                continue; // the same at another thread count
            }
            const double growth = CpuRatio(small.engines[i], large->engines[i]);
            lines +=
                Format("%-15s %-16s %s takes %s the CPU time of %s\n",
                       i == 0 ? small.scene.curve.c_str() : "", small.engines[i].engine.c_str(),
                       large->scene.name.c_str(), growth > 0.0 ? RatioText(growth).c_str() : "?",
                       small.scene.name.c_str());
        }
    }
    return lines.empty() ? "" : "\n" + lines;
}

/// What the calls of some scenes found, an engine a line.
std::string FoundLines(const std::vector<BenchResult>& results)
{
    std::string lines;
    for (const BenchResult& result : results)
    {
        for (const BenchFigures& engine : result.engines)
        {
            if (result.scene.found.empty() || !engine.failure.empty())
            {
                continue;
            }
            const bool isFirst = &engine == &result.engines.front();
            lines += Format("%-15s %-16s found %.0f %s, in sum %.6g\n",
                            isFirst ? result.scene.name.c_str() : "", engine.engine.c_str(),
                            engine.found, result.scene.found.c_str(), engine.foundSum);
        }
    }
    return lines.empty() ? "" : "\n" + lines;
}

} // namespace

std::string TimeText(double seconds)
{
    const bool isLong = seconds >= 0.9995e-3;
    const double value = seconds * (isLong ? 1e3 : 1e6);
    const int decimals = value >= 99.95 ? 0 : value >= 9.995 ? 1 : value >= 0.0995 ? 2 : 3;
    return Format("%.*f %s", decimals, value, isLong ? "ms" : "us");
}

std::string RatioText(double ratio)
{
    if (ratio <= 0.0)
    {
        return "";
    }
    return ratio >= 999.5   ? ChartNumber(std::stod(Format("%.3g", ratio))) + "x"
           : ratio >= 99.95 ? Format("%.0fx", ratio)
           : ratio >= 9.995 ? Format("%.1fx", ratio)
                            : Format("%.2fx", ratio);
}

std::string BenchTable(const std::vector<BenchResult>& results)
{
    const bool withThreads = HasThreads(results);
    std::string table = Head(withThreads);
    for (const BenchResult& result : results)
    {
        for (const BenchFigures& engine : result.engines)
        {
            table += Row(result, engine, withThreads);
        }
    }
    return table + FoundLines(results) + GrowthLines(results);
}

} // namespace boxreel
