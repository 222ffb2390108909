// SPDX-License-Identifier: MIT
#include <debugdraw/ScaleBar.h>

#include <debugdraw/NiceNumbers.h>
#include <debugdraw/Paper.h>
#include <debugdraw/TextWidth.h>

namespace boxreel
{

void AddScaleBar(DrawList& list, const Camera& paper, double pixelsPerMeter, Vec2 left, double room)
{
    constexpr double kEnd = 4.0;                        // half the height of the end lines [px]
    constexpr double kGap = 8.0;                        // between bar and text [px]
    const double longest = 0.5 * room / pixelsPerMeter; // [m]
    if (!(longest > 1e-12 && longest < 1e12))
    {
        return;
    }
    const Paper sheet(list, paper);
    const double meters = NiceBelow(longest);
    const std::string label = NumberBy(meters, meters) + " m";
    if (left.x + meters * pixelsPerMeter + kGap + TextWidth(label) > paper.width)
    {
        return; // the bar's length is unknown
    }
    const PixelPoint from{left.x, left.y};
    const PixelPoint to{left.x + meters * pixelsPerMeter, left.y};
    sheet.Line(from, to, kInk);
    for (const PixelPoint end : {from, to})
    {
        sheet.Line({end.x, end.y - kEnd}, {end.x, end.y + kEnd}, kInk);
    }
    sheet.Text({to.x + kGap, to.y}, label, {0.0, 0.5}, kInk);
}

} // namespace boxreel
