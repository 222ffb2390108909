// SPDX-License-Identifier: MIT
#include "Format.h"
#include "RenderBench.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

std::string Milliseconds(double seconds)
{
    return std::isfinite(seconds) ? Format(seconds < 1e-4 ? "%.4f" : "%.3g", seconds * 1e3) : "-";
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

std::string Cell(const std::string& text, bool isMissed)
{
    return Format(" %11s%s", text.c_str(), isMissed ? "!" : " ");
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
    row += Cell(std::isfinite(ratio) ? Format("%.2f", ratio) : "-",
                isHeld && Misses(ratio, info.goalEmpty));
    if (isCpu)
    {
        row += Cell(Format("%.2f", figures.rms), isHeld && Misses(figures.rms, info.goalRms));
        row += Cell(Format("%.1f", figures.most), false);
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
    head += Cell("empty/floor", false) + Cell("RMSE", false) + Cell("most", false);
    return head.substr(0, head.find_last_not_of(' ') + 1) + "\n";
}

std::string GoalLines(const RenderResult& result)
{
    std::string lines;
    for (const RenderGoal& goal : RenderGoals(result))
    {
        lines += Format("goal %s: %s  %.3g%s, at most %.3g%s\n", goal.IsMet() ? "met   " : "MISSED",
                        Format("%-27s", goal.what.c_str()).c_str(), goal.reached, goal.unit.c_str(),
                        goal.goal, goal.unit.c_str());
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

constexpr const char* kFootnote =
    "Times are medians of a frame in ms: all shapes changed, one in twenty changed, around one "
    "place or all\nover the picture, none, no shapes at all, and the GL library told to clear and "
    "to hand over its pixels\n(the floor). Threads are the rasteriser's: one is LP_NUM_THREADS=0, "
    "own is as the environment has it.\n`-`: what draws all of it whatever has changed takes the "
    "time of `full`. RMSE: root mean square of the\ndifferences from a truth of 16 x 16 samples a "
    "pixel, over the red, green and blue of the pixels whose\nsamples are not all alike, in steps "
    "of 8 bits; most: of any pixel. A sign (!) stands where a goal, for\nCPU time and one thread, "
    "is missed.\n";

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
    return table + kFootnote;
}

} // namespace boxreel
