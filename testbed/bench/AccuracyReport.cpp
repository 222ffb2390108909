// SPDX-License-Identifier: MIT
#include "AccuracySweep.h"
#include "Benchmark.h"
#include "Format.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

std::string Ending(const AccuracyFigures& run)
{
    return !run.failure.empty() ? run.failure : !run.ending.empty() ? run.ending : "not finite";
}

/// 2/1, or 10 where there is one kind; empty for figures of a program that did not say.
std::string EachText(const SubStepIterations& each)
{
    return each.velocity <= 0 ? ""
           : each.position <= 0
               ? std::to_string(each.velocity)
               : std::to_string(each.velocity) + "/" + std::to_string(each.position);
}

std::string Row(const AccuracyCase& info, const AccuracyFigures& run)
{
    const AccuracySettings& s = run.settings;
    const std::string iterations =
        std::to_string(s.velocityIterations) + "/" + std::to_string(s.positionIterations);
    std::string row = Format("%-17s %-16s %4d %10s %9d %9s ", info.name.c_str(), run.engine.c_str(),
                             s.hz, iterations.c_str(), s.subSteps, EachText(run.each).c_str());
    if (!HasFigures(run))
    {
        return row + Format("%11s %-6s %9s %9s  %s\n", "-", "", "-", "-", Ending(run).c_str());
    }
    const std::string verdict = !run.ending.empty()     ? run.ending
                                : MeetsGoals(info, run) ? "goal met"
                                                        : MissedRemarks(info, run);
    row += Format("%11.4g %-6s %9s %9s  %s", run.error, info.unit.c_str(),
                  TimeText(run.cpu).c_str(), TimeText(run.CpuOfAFrame()).c_str(), verdict.c_str());
    return row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
}

const AccuracyFigures* UsualRun(const AccuracyResult& result, const std::string& engine,
                                int subSteps)
{
    const AccuracySettings usual = UsualSettings(result, engine, subSteps);
    for (const AccuracyFigures& run : result.runs)
    {
        const AccuracySettings& s = run.settings;
        if (run.engine == engine && s.hz == usual.hz && s.subSteps == usual.subSteps &&
            s.velocityIterations == usual.velocityIterations)
        {
            return &run;
        }
    }
    return nullptr;
}

std::string ErrorText(const AccuracyFigures& run)
{
    return !run.ending.empty() || !HasFigures(run) ? Ending(run) : Format("%.3g", run.error);
}

std::string SummaryRow(const AccuracyResult& result, const std::vector<std::string>& engines,
                       int subSteps)
{
    const AccuracyCase& info = result.info;
    std::string row = Format("%-17s %6.4g %-6s", info.name.c_str(), info.goal, info.unit.c_str());
    const AccuracyFigures* ours = UsualRun(result, engines.front(), subSteps);
    bool isSlower = false;
    for (const std::string& engine : engines)
    {
        const AccuracyFigures* run = UsualRun(result, engine, subSteps);
        const bool isTimed = run != nullptr && ours != nullptr && run->cpu > 0.0 && ours->cpu > 0.0;
        isSlower = isSlower || (isTimed && IsGoalPeer(engine) && run->cpu < ours->cpu);
        row += Format(" %10s %8s %6s", run != nullptr ? ErrorText(*run).c_str() : "not run",
                      isTimed ? TimeText(run->CpuOfAFrame()).c_str() : "",
                      isTimed && run != ours
                          ? Format("%.2fx", run->CpuOfAFrame() / ours->CpuOfAFrame()).c_str()
                          : "");
    }
    if (ours == nullptr || !MeetsGoals(info, *ours))
    {
        const bool ended = ours != nullptr && HasFigures(*ours) && ours->ending.empty();
        const std::string missed = ended ? MissedRemarks(info, *ours) : "";
        return row + "  goal not met" + (missed.empty() ? "\n" : ": " + missed + "\n");
    }
    return row + (isSlower ? "  goal met, slower\n" : "  goal met\n");
}

} // namespace

bool HasFigures(const AccuracyFigures& run)
{
    return run.failure.empty() && run.held && std::isfinite(run.error) && run.cpu > 0.0;
}

std::string MissedRemarks(const AccuracyCase& info, const AccuracyFigures& run)
{
    std::string missed;
    for (const RemarkGoal& goal : info.remarkGoals)
    {
        const auto remark = std::find_if(run.remarks.begin(), run.remarks.end(),
                                         [&](const auto& one) { return one.first == goal.name; });
        const double value = remark != run.remarks.end() ? remark->second : kNoValue;
        if (goal.isLeast ? value >= goal.bound : value <= goal.bound)
        {
            continue;
        }
        missed += (missed.empty() ? "" : "; ") + goal.name +
                  (std::isfinite(value) ? Format(" %.3g", value) : " unknown") +
                  Format(", at %s %g", goal.isLeast ? "least" : "most", goal.bound);
    }
    return missed;
}

bool MeetsGoals(const AccuracyCase& info, const AccuracyFigures& run)
{
    return HasFigures(run) && run.ending.empty() && run.error <= info.goal &&
           MissedRemarks(info, run).empty();
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

AccuracySettings UsualSettings(const AccuracyResult& result, const std::string& engine,
                               int subSteps)
{
    AccuracySettings usual;
    for (const AccuracyFigures& run : result.runs)
    {
        usual.subSteps =
            run.engine == engine && run.settings.subSteps > 1 ? subSteps : usual.subSteps;
    }
    return usual;
}

std::string AccuracyTable(const std::vector<AccuracyResult>& results)
{
    std::string table =
        Format("%-17s %-16s %4s %10s %9s %9s %11s %-6s %9s %9s\n", "case", "engine", "Hz",
               "iterations", "sub-steps", "each gets", "error", "", "CPU/step", "per 1/60 s");
    for (const AccuracyResult& result : results)
    {
        for (const AccuracyFigures& run : result.runs)
        {
            table += Row(result.info, run);
        }
    }
    return table + "\n" + AccuracySummary(results);
}

std::string AccuracySummary(const std::vector<AccuracyResult>& results)
{
    const std::vector<std::string> engines = EnginesOf(results.front());
    std::string summary =
        "At 60 Hz with 8/3 iterations: the error, the CPU time of a step, and how "
        "many times that\nof the first engine it is; slower: than Box2D.\n";
    for (const int subSteps : {2, 4})
    {
        summary += Format("\n%-17s %6s %-6s", Format("%d sub-steps", subSteps).c_str(), "goal", "");
        for (const std::string& engine : engines)
        {
            summary += Format(" %26s", engine.c_str());
        }
        summary += "\n";
        for (const AccuracyResult& result : results)
        {
            summary += SummaryRow(result, engines, subSteps);
        }
    }
    return summary;
}

} // namespace boxreel
