// SPDX-License-Identifier: MIT
#include "Format.h"
#include "RenderBench.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

/// Three digits, or four places where that is less: times stand below each other.
std::string Milliseconds(double seconds)
{
    const double value = seconds * 1e3;
    const int places = value >= 100.0 ? 0 : value >= 10.0 ? 1 : value >= 1.0 ? 2 : 3;
    return std::isfinite(value) ? Format("%.*f", value < 0.1 ? 4 : places, value) : "-";
}

/// Goals of the rows of ours with one raster thread, by the clock of CPU time.
bool Misses(double value, double goal)
{
    return goal > 0.0 && !(value <= goal);
}

double GoalOf(const RenderCase& info, const RenderWork& work)
{
    const RenderTimes RenderFigures::*times = work.times;
    return times == &RenderFigures::full                                         ? info.goalFull
           : times == &RenderFigures::together || times == &RenderFigures::apart ? info.goalChanged
           : times == &RenderFigures::none                                       ? info.goalNone
                                                                                 : 0.0;
}

constexpr int kNarrow = 6; // for errors

std::string Number(double value)
{
    return std::isfinite(value) ? Format("%.2f", value) : "-";
}

std::string Cell(const std::string& text, bool isMissed, int width = 10)
{
    return Format(" %*s%s", width, text.c_str(), isMissed ? "!" : " ");
}

/// One clock of one method.
std::string Row(const RenderCase& info, const RenderFigures& figures, bool isCpu)
{
    const bool isHeld = isCpu && figures.isOurs && figures.threads == "0";
    const char* threads = !figures.isOurs ? "" : figures.threads == "0" ? "one" : "own";
    std::string row = Format("%-20s %-7s %-4s", isCpu ? figures.method.c_str() : "",
                             isCpu ? threads : "", isCpu ? "CPU" : "wall");
    for (const RenderWork& work : RenderWorks())
    {
        const RenderTimes& times = figures.*work.times;
        const double time = isCpu ? times.cpu : times.wall;
        row += Cell(Milliseconds(time), isHeld && Misses(time, GoalOf(info, work)));
    }
    const double ratio = isCpu ? figures.EmptyRatio() : figures.empty.wall / figures.floor.wall;
    row += Cell(Number(ratio), isHeld && Misses(ratio, info.goalEmpty));
    if (isCpu)
    {
        row += Cell(Number(figures.rms), isHeld && Misses(figures.rms, info.goalRms), kNarrow);
        row += Cell(Format("%.1f", figures.most), false, kNarrow);
        row += figures.wrong.empty() ? "" : "  wrong: " + figures.wrong;
    }
    return row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
}

std::string Head()
{
    std::string head = Format("%-20s %-7s %-4s", "method", "threads", "ms");
    for (const RenderWork& work : RenderWorks())
    {
        head += Cell(work.title, false);
    }
    head += Cell("over floor", false) + Cell("RMSE", false, kNarrow) + Cell("most", false, kNarrow);
    return head.substr(0, head.find_last_not_of(' ') + 1) + "\n";
}

std::string GoalLines(const RenderResult& result)
{
    std::string lines;
    for (const RenderGoal& goal : RenderGoals(result))
    {
        lines += Format("%-13s%-26s %8.3g%s, at most %.3g%s\n",
                        goal.IsMet() ? "goal met:" : "goal MISSED:", goal.what.c_str(),
                        goal.reached, goal.unit.c_str(), goal.goal, goal.unit.c_str());
    }
    return lines;
}

double EdgePixels(const RenderResult& result)
{
    double most = 0.0;
    for (const RenderFigures& figures : result.methods)
    {
        most = std::max(most, figures.edgePixels);
    }
    return most;
}

const RenderFigures* FindWithOneThread(const RenderResult& result, const std::string& method)
{
    for (const RenderFigures& figures : result.methods)
    {
        if (figures.method == method && figures.threads == "0" && figures.failure.empty())
        {
            return &figures;
        }
    }
    return nullptr;
}

/// Those that ran in any case, in the order in which they first come; ours is the first.
std::vector<std::string> MethodsOf(const std::vector<RenderResult>& results)
{
    std::vector<std::string> methods;
    for (const RenderResult& result : results)
    {
        for (const RenderFigures& figures : result.methods)
        {
            if (FindWithOneThread(result, figures.method) != nullptr &&
                std::find(methods.begin(), methods.end(), figures.method) == methods.end())
            {
                methods.push_back(figures.method);
            }
        }
    }
    return methods;
}

std::string SummaryRow(const RenderResult& result, const std::vector<std::string>& methods)
{
    std::string row = Format("%-13s", result.info.name.c_str());
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
        const RenderFigures* const found = FindWithOneThread(result, methods[i]);
        const RenderFigures figures = found != nullptr ? *found : RenderFigures();
        row += Format(i == 0 ? "%12s" : "%13s", Milliseconds(figures.full.cpu).c_str());
        if (i == 0)
        {
            row += Format("%10s%10s%10s%12s", Milliseconds(figures.together.cpu).c_str(),
                          Milliseconds(figures.apart.cpu).c_str(),
                          Milliseconds(figures.none.cpu).c_str(),
                          Number(figures.EmptyRatio()).c_str());
        }
        row += Format("%8s", Number(figures.rms).c_str());
    }
    return row + "\n";
}

constexpr const char* kFootnote =
    R"(Times are medians of a frame in ms: all shapes changed; one in twenty changed, around one
place (together) or all over the picture (apart); none; no shapes at all (empty), and the GL
library told to clear and to hand over its pixels. A `-`: whoever draws all of it whatever has
changed takes the time of `full`. Threads are the rasteriser's: one is LP_NUM_THREADS=0, own as
the environment has it. RMSE: root mean square of the differences from a truth of 16 x 16 samples
a pixel, over the red, green and blue of the pixels whose samples are not all alike, in steps of
8 bits; most: of any pixel. A sign (!) stands where a goal, for CPU time and one thread, is missed.
)";

} // namespace

std::string RenderTable(const std::vector<RenderResult>& results)
{
    std::string table;
    for (const RenderResult& result : results)
    {
        table += Format("%s: %s, %.0f pixels at edges\n", result.info.name.c_str(),
                        result.info.what.c_str(), EdgePixels(result));
        table += Head();
        for (const RenderFigures& figures : result.methods)
        {
            table += figures.failure.empty()
                         ? Row(result.info, figures, true) + Row(result.info, figures, false)
                         : figures.method + " " + figures.failure + "\n";
        }
        table += GoalLines(result) + "\n";
    }
    return table + RenderSummary(results) + "\n" + kFootnote;
}

std::string RenderSummary(const std::vector<RenderResult>& results)
{
    const std::vector<std::string> methods = MethodsOf(results);
    std::string names = Format("%-13s", ""), heads = Format("%-13s", "case");
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
        names += Format(i == 0 ? "%62s" : "%21s", methods[i].c_str());
        heads += Format(i == 0 ? "%12s" : "%13s", "full");
        heads += i == 0 ? Format("%10s%10s%10s%12s", "together", "apart", "unchanged", "over floor")
                        : "";
        heads += Format("%8s", "RMSE");
    }
    std::string summary =
        "CPU time of a frame with one raster thread [ms], and the error at edges:\n" + names +
        "\n" + heads + "\n";
    for (const RenderResult& result : results)
    {
        summary += SummaryRow(result, methods);
    }
    return summary;
}

} // namespace boxreel
