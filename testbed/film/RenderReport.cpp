// SPDX-License-Identifier: MIT
#include "RenderReport.h"

#include <cstdio>

namespace boxreel
{
namespace
{

/// "12.3 %"; of nothing, nothing.
std::string Percent(std::int64_t part, std::int64_t whole)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%",
                  whole > 0 ? 100.0 * double(part) / double(whole) : 0.0);
    return text;
}

std::string Line(const char* what, const std::string& number, const std::string& explanation)
{
    char text[160];
    std::snprintf(text, sizeof text, "\n  %-10s  %9s   %s", what, number.c_str(),
                  explanation.c_str());
    return text;
}

} // namespace

std::string DescribeDrawing(const RenderTotals& totals)
{
    const std::int64_t whole = totals.frames - totals.framesInPart - totals.framesUnchanged;
    const std::int64_t leftAlone = totals.items - totals.itemsDrawn - totals.itemsOutside;
    char calls[32];
    std::snprintf(calls, sizeof calls, "%.1f a frame",
                  totals.frames > 0 ? double(totals.drawCalls) / double(totals.frames) : 0.0);
    return "Rendering:" +
           Line("frames", std::to_string(totals.frames),
                std::to_string(whole) + " as a whole, " + std::to_string(totals.framesInPart) +
                    " in part, " + std::to_string(totals.framesUnchanged) + " unchanged") +
           Line("pixels", Percent(totals.pixelsDrawn, totals.pixels), "drawn, the rest unchanged") +
           Line("items", std::to_string(totals.items),
                Percent(totals.itemsDrawn, totals.items) + " drawn, " +
                    Percent(leftAlone, totals.items) + " unchanged, " +
                    Percent(totals.itemsOutside, totals.items) + " outside the picture") +
           Line("", Percent(totals.itemsReused, totals.items), "reused from the frame before") +
           Line("draw calls", std::to_string(totals.drawCalls), calls);
}

std::string DescribeSimulation(const SimulationTotals& totals)
{
    return "Simulation:" + Line("steps", std::to_string(totals.steps),
                                totals.firstStep > 0 ? "from the snapshot of step " +
                                                           std::to_string(totals.firstStep) + " on"
                                                     : "from the start");
}

} // namespace boxreel
