// SPDX-License-Identifier: MIT
#include "BenchChart.h"

#include <algorithm>

namespace boxreel
{
namespace
{

/// The table keeps to ASCII; a chart need not.
std::string Typeset(std::string text)
{
    if (!text.empty() && text.back() == 'x')
    {
        text.replace(text.size() - 1, 1, "\u00d7");
    }
    if (text.size() > 3 && text.ends_with(" us"))
    {
        text.replace(text.size() - 2, 2, "\u00b5s");
    }
    return text;
}

/// Peers by their names, in the order in which they first come.
std::vector<std::string> PeersOf(const std::vector<BenchResult>& results)
{
    std::vector<std::string> names;
    for (const BenchResult& result : results)
    {
        for (const BenchFigures& engine : result.engines)
        {
            const bool known = std::find(names.begin(), names.end(), engine.engine) != names.end();
            if (!engine.isOurs && engine.failure.empty() && !known)
            {
                names.push_back(engine.engine);
            }
        }
    }
    return names;
}

/// The name and version of ours, with the threads when there are several.
std::string OursIn(const std::vector<BenchResult>& results)
{
    for (const BenchResult& result : results)
    {
        const BenchFigures& ours = result.engines.front();
        if (ours.failure.empty())
        {
            return ours.engine +
                   (ours.threads > 1 ? " on " + std::to_string(ours.threads) + " threads" : "");
        }
    }
    return "boxreel";
}

ChartBar BarOf(const BenchResult& result, const BenchFigures& peer)
{
    const BenchFigures& ours = result.engines.front();
    ChartBar bar;
    const double ratio = CpuRatio(ours, peer);
    if (ratio > 0.0 && IsLikePeers(ours))
    {
        bar.value = ratio;
        bar.label = Typeset(RatioText(ratio));
    }
    else
    {
        const bool isOurFault = !IsComparable(ours) || IsComparable(peer);
        bar.label = "not compared: " + (isOurFault ? "boxreel " + ours.verdict : peer.verdict) +
                    (ratio > 0.0 ? " (" + Typeset(RatioText(ratio)) + ")" : "");
    }
    if (IsGoalPeer(peer.engine) && result.scene.goalTimesFaster > 0.0)
    {
        bar.mark = result.scene.goalTimesFaster;
    }
    else if (IsGoalPeer(peer.engine) && result.scene.goalSeconds > 0.0 && IsComparable(peer))
    {
        bar.mark = peer.cpu / result.scene.goalSeconds;
    }
    if (bar.mark > bar.value) // beyond the bar's end, where the label stands too
    {
        bar.label += ", goal " + Typeset(RatioText(bar.mark));
    }
    return bar;
}

ChartGroup GroupOf(const BenchResult& result, const std::vector<std::string>& peers)
{
    const BenchFigures& ours = result.engines.front();
    ChartGroup group;
    group.name = result.scene.name;
    group.value = IsComparable(ours) ? Typeset(TimeText(ours.cpu)) : "";
    group.detail = result.scene.what;
    for (const std::string& name : peers)
    {
        const auto peer =
            std::find_if(result.engines.begin(), result.engines.end(),
                         [&name](const BenchFigures& engine) { return engine.engine == name; });
        group.bars.push_back(peer != result.engines.end() ? BarOf(result, *peer)
                                                          : ChartBar{.label = "not run"});
    }
    return group;
}

} // namespace

Result<BarChart> RatioChart(const std::vector<BenchResult>& results)
{
    const std::vector<std::string> peers = PeersOf(results);
    if (peers.empty())
    {
        return Error{ErrorKind::Unusable,
                     "There is no peer to compare with in a chart; install libbox2d-dev or "
                     "libchipmunk-dev, then configure and build again."};
    }
    BarChart chart;
    chart.frame.title = "How many times faster is boxreel?";
    chart.frame.subtitle = OursIn(results) + "; CPU time of the peer over CPU time of boxreel, " +
                           "the same scenes run in turn";
    chart.axis = {"times faster than the peer", true};
    chart.start = 1.0;
    chart.startLabel = "equally fast";
    chart.markName = "goal against Box2D 2.4";
    for (const std::string& peer : peers)
    {
        // The first colour is that of ours, in the curve.
        chart.series.push_back({"than " + peer, int(chart.series.size()) + 1});
    }
    for (const BenchResult& result : results)
    {
        chart.groups.push_back(GroupOf(result, peers));
    }
    chart.valueTitle = "boxreel's time";
    chart.frame.notes = {
        "Times are CPU times of a step of 1/60 s, or of the one thing that the scene does; 8 "
        "velocity "
        "and 3 position iterations, Chipmunk 10.",
        "No bar where boxreel's run does not end like the peers', or where a run burst: a time "
        "says nothing then."};
    return chart;
}

namespace
{

struct CurveLook
{
    const char* curve;
    const char* words;
    ChartStroke stroke;
};

/// One that is not known, of another version's file, looks like what sleeps.
CurveLook LookOf(const std::string& curve)
{
    constexpr CurveLook kLooks[] = {{"static", "static", ChartStroke::Solid},
                                    {"asleep", "asleep", ChartStroke::Dashed},
                                    {"asleep4", "asleep, 4 sub-steps", ChartStroke::Dotted}};
    for (const CurveLook& look : kLooks)
    {
        if (curve == look.curve)
        {
            return look;
        }
    }
    return {curve.c_str(), curve.c_str(), ChartStroke::Dashed};
}

} // namespace

Result<LineChart> CurveChart(const std::vector<BenchResult>& results)
{
    LineChart chart;
    std::vector<std::string> engines; // a colour each
    for (const BenchResult& result : results)
    {
        for (const BenchFigures& engine : result.engines)
        {
            const bool first = !engine.isOurs || &engine == &result.engines.front();
            if (result.scene.curve.empty() || !IsComparable(engine) || !first)
            {
                continue;
            }
            if (std::find(engines.begin(), engines.end(), engine.engine) == engines.end())
            {
                engines.push_back(engine.engine);
            }
            const CurveLook look = LookOf(result.scene.curve);
            const std::string name = engine.engine + ", " + look.words;
            auto line =
                std::find_if(chart.lines.begin(), chart.lines.end(),
                             [&name](const ChartLine& known) { return known.series.name == name; });
            if (line == chart.lines.end())
            {
                const auto color = std::find(engines.begin(), engines.end(), engine.engine);
                chart.lines.push_back({{name, int(color - engines.begin()), look.stroke}, {}});
                line = chart.lines.end() - 1;
            }
            line->points.push_back({result.scene.count, engine.cpu * 1e6, ""});
        }
    }
    if (chart.lines.empty())
    {
        return Error{ErrorKind::Unusable, "None of these scenes is part of the curve; "
                                          "`boxreel bench --curve` runs those that are."};
    }
    const auto isEarlier = [](const ChartPoint& a, const ChartPoint& b) { return a.x < b.x; };
    for (ChartLine& line : chart.lines)
    {
        std::sort(line.points.begin(), line.points.end(), isEarlier);
        if (line.points.size() > 1)
        {
            line.points.back().label =
                Typeset(RatioText(line.points.back().y / line.points.front().y));
        }
    }
    chart.frame.title = "What bodies cost that do nothing";
    chart.frame.subtitle = "CPU time of a step with 200 moving boxes and a growing number of "
                           "static boxes, or of boxes asleep";
    chart.frame.notes = {
        "At the end of each line: the time at its last point over the time at its first. Steps of "
        "1/60 s; 8 velocity and 3 position iterations, Chipmunk 10.",
        "Engines that know no sub-steps take one step where 4 are named."};
    chart.x = {"static boxes, or boxes asleep", true};
    chart.y = {"CPU time of a step [\u00b5s]", true};
    return chart;
}

} // namespace boxreel
