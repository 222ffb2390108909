// SPDX-License-Identifier: MIT
#include "AccuracySweep.h"
#include "Benchmark.h"
#include "ChartScale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace boxreel
{
namespace
{

/// A smaller gain is no gain: it would end a curve at a price that bought nothing.
constexpr double kBetter = 0.99;

bool HasPoint(const AccuracyFigures& run)
{
    return run.failure.empty() && run.held && std::isfinite(run.error) && run.cpu > 0.0;
}

std::vector<std::string> EnginesOf(const AccuracyResult& result)
{
    std::vector<std::string> engines;
    for (const AccuracyFigures& run : result.runs)
    {
        if (std::find(engines.begin(), engines.end(), run.engine) == engines.end())
        {
            engines.push_back(run.engine);
        }
    }
    return engines;
}

/// 8/3 at 60 Hz, with the sub-steps where there are any.
std::string SettingsText(const AccuracySettings& s)
{
    return std::to_string(s.velocityIterations) + "/" + std::to_string(s.positionIterations) +
           " at " + std::to_string(s.hz) + " Hz" +
           (s.subSteps > 1 ? " x " + std::to_string(s.subSteps) : "");
}

std::string Row(const AccuracyResult& result, const AccuracyFigures& run)
{
    char text[320];
    if (!HasPoint(run))
    {
        std::snprintf(text, sizeof text, "%-18s %-16s %-20s %s\n", result.info.name.c_str(),
                      run.engine.c_str(), SettingsText(run.settings).c_str(),
                      run.failure.empty() ? "not finite" : run.failure.c_str());
        return text;
    }
    std::snprintf(text, sizeof text, "%-18s %-16s %-20s %10.4g %-6s %9s %9s  %s\n",
                  result.info.name.c_str(), run.engine.c_str(), SettingsText(run.settings).c_str(),
                  run.error, result.info.unit.c_str(), TimeText(run.cpu).c_str(),
                  TimeText(run.CpuOfAFrame()).c_str(),
                  run.error <= result.info.goal ? "goal met" : "");
    return text;
}

/// What an error of nothing is drawn as, for a logarithm has no zero.
double LeastDrawn(const AccuracyCase& info)
{
    return info.goal > 0.0 ? info.goal / 1000.0 : 0.1;
}

void AppendGoal(LineChart& chart, const AccuracyCase& info)
{
    double from = chart.lines.front().points.front().x, to = from;
    for (const ChartLine& line : chart.lines)
    {
        for (const ChartPoint& point : line.points)
        {
            from = std::min(from, point.x);
            to = std::max(to, point.x);
        }
    }
    ChartLine goal;
    goal.series.name = "goal";
    goal.series.color = 5;
    goal.series.dashed = true;
    goal.points = {{from, info.goal, ""}, {to, info.goal, ""}};
    chart.lines.push_back(goal);
}

} // namespace

std::vector<AccuracyFigures> BestRuns(const AccuracyResult& result, const std::string& engine)
{
    std::vector<AccuracyFigures> runs;
    for (const AccuracyFigures& run : result.runs)
    {
        if (run.engine == engine && HasPoint(run))
        {
            runs.push_back(run);
        }
    }
    std::sort(runs.begin(), runs.end(), [](const AccuracyFigures& a, const AccuracyFigures& b) {
        return a.CpuOfAFrame() != b.CpuOfAFrame() ? a.CpuOfAFrame() < b.CpuOfAFrame()
                                                  : a.error < b.error;
    });
    std::vector<AccuracyFigures> best;
    for (const AccuracyFigures& run : runs)
    {
        if (best.empty() || run.error < kBetter * best.back().error)
        {
            best.push_back(run);
        }
    }
    return best;
}

std::string AccuracyTable(const std::vector<AccuracyResult>& results)
{
    char head[320];
    std::snprintf(head, sizeof head, "%-18s %-16s %-20s %10s %-6s %9s %9s\n", "case", "engine",
                  "iterations and steps", "error", "", "CPU/step", "CPU/frame");
    std::string table = head;
    for (const AccuracyResult& result : results)
    {
        for (const AccuracyFigures& run : result.runs)
        {
            table += Row(result, run);
        }
    }
    return table;
}

Result<LineChart> AccuracyChart(const AccuracyResult& result)
{
    const AccuracyCase& info = result.info;
    LineChart chart;
    for (const std::string& engine : EnginesOf(result))
    {
        const std::vector<AccuracyFigures> best = BestRuns(result, engine);
        if (best.empty())
        {
            continue;
        }
        ChartLine line;
        line.series.name = engine;
        line.series.color = int(chart.lines.size());
        for (const AccuracyFigures& run : best)
        {
            line.points.push_back(
                {run.CpuOfAFrame() * 1e6, std::max(run.error, LeastDrawn(info)), ""});
        }
        line.points.back().label = SettingsText(best.back().settings);
        chart.lines.push_back(line);
    }
    if (chart.lines.empty())
    {
        return Error{ErrorKind::Unusable,
                     "No run of '" + info.name + "' has held, so there is nothing to draw."};
    }
    if (info.goal > 0.0)
    {
        AppendGoal(chart, info);
    }
    chart.frame.title = info.name;
    chart.frame.subtitle = info.what;
    chart.frame.notes = {
        "Each line goes through the settings that no other of that engine beats in both, and ends "
        "with the most accurate, which is named.",
        "An error below " + ChartNumber(LeastDrawn(info)) + " " + info.unit +
            " is drawn there. Velocity/position iterations; Chipmunk 10 for 8/3."};
    chart.x = {"CPU time of 1/60 s [\u00b5s]", true};
    chart.y = {"error [" + info.unit + "]", true};
    return chart;
}

} // namespace boxreel
