// SPDX-License-Identifier: MIT
#include "ChartParts.h"

#include <algorithm>

namespace boxreel
{
namespace
{

constexpr double kNamesWidth = 296.0; // left of the plot, the values included
constexpr double kValueWidth = 66.0;
constexpr double kLabelRoom = 74.0; // right of the plot, for what is written beside a bar
constexpr double kBarHeight = 13.0;
constexpr double kBarGap = 4.0;
constexpr double kGroupGap = 13.0;
constexpr double kHeadHeight = 114.0; // what PaintHead takes for one row of legend

double GroupHeight(const BarChart& chart)
{
    const double bars = double(std::max<std::size_t>(chart.series.size(), 2));
    return bars * (kBarHeight + kBarGap) - kBarGap + kGroupGap;
}

std::vector<double> AllValues(const BarChart& chart)
{
    std::vector<double> values{chart.start};
    for (const ChartGroup& group : chart.groups)
    {
        for (const ChartBar& bar : group.bars)
        {
            values.push_back(bar.value);
            values.push_back(bar.mark);
        }
    }
    return values;
}

/// From the start to the value; returns where it ends.
double PaintBody(ChartCanvas& canvas, const ChartColor& color, double start, double end, double y)
{
    const double left = std::min(start, end);
    const double width = std::max(1.5, std::abs(end - start));
    canvas.Rectangle(left, y, width, kBarHeight, color);
    return end < start ? left : left + width;
}

void PaintBar(ChartCanvas& canvas, const ChartBar& bar, const ChartColor& color,
              const ChartScale& scale, double start, double y)
{
    const double baseline = y + kBarHeight - 2.5;
    const bool hasBar = std::isfinite(bar.value);
    const double end =
        hasBar ? PaintBody(canvas, color, start, scale.At(bar.value), y) : start + 1.0;
    const double mark = std::isfinite(bar.mark) ? scale.At(bar.mark) : kNoValue;
    if (std::isfinite(mark))
    {
        canvas.Lines({{mark, y - 2.5}, {mark, y + kBarHeight + 2.5}}, {2.5, kInk});
    }
    TextStyle style{.size = 11.0, .color = hasBar ? kInk : kSoftInk};
    if (end < start)
    {
        style.place = TextPlace::LeftOf;
        canvas.Text(end - 5.0, baseline, bar.label, style);
        return;
    }
    // A label that the mark would cross goes to its other side.
    const double width = canvas.TextWidth(bar.label, style);
    const bool crossed = mark > end - 3.0 && mark < end + 10.0 + width;
    canvas.Text((crossed ? mark : end) + 5.0, baseline, bar.label, style);
}

/// Ends at `x`.
void PaintNames(ChartCanvas& canvas, const BarChart& chart, const ChartGroup& group, double x,
                double middle)
{
    canvas.Text(x, middle + 4.0, group.value,
                {.size = 11.5, .color = kInk, .place = TextPlace::LeftOf});
    const double right = chart.valueTitle.empty() ? x : x - kValueWidth;
    const bool hasDetail = !group.detail.empty();
    canvas.Text(right, middle + (hasDetail ? -1.5 : 4.0), group.name,
                {.size = 12.0, .color = kInk, .place = TextPlace::LeftOf, .bold = true});
    canvas.Text(right, middle + 11.5, group.detail,
                {.size = 10.0, .color = kSoftInk, .place = TextPlace::LeftOf});
}

} // namespace

double HeightOf(const BarChart& chart)
{
    return kHeadHeight + double(chart.groups.size()) * GroupHeight(chart) + kGroupGap +
           kAxisHeight + NotesHeight(chart.frame) + kMargin;
}

void Paint(ChartCanvas& canvas, const BarChart& chart)
{
    std::vector<LegendEntry> legend;
    for (const ChartSeries& series : chart.series)
    {
        legend.push_back({series, LegendKey::Box});
    }
    if (!chart.markName.empty())
    {
        legend.push_back({{chart.markName}, LegendKey::Tick});
    }
    PaintHead(canvas, chart.frame, legend);

    const double groupHeight = GroupHeight(chart);
    PlotArea area{kMargin + kNamesWidth, kHeadHeight, chart.frame.width - kMargin - kLabelRoom,
                  0.0};
    area.bottom = area.top + double(chart.groups.size()) * groupHeight + kGroupGap;
    const ChartScale scale(chart.axis, AllValues(chart), area.left, area.right);
    PaintAcross(canvas, chart.axis, scale, area);

    const double start = scale.At(chart.start);
    double y = area.top + kGroupGap;
    for (const ChartGroup& group : chart.groups)
    {
        for (std::size_t i = 0; i < group.bars.size(); ++i)
        {
            PaintBar(canvas, group.bars[i], SeriesColor(chart.series[i].color), scale, start,
                     y + double(i) * (kBarHeight + kBarGap));
        }
        PaintNames(canvas, chart, group, area.left - 12.0, y + 0.5 * (groupHeight - kGroupGap));
        y += groupHeight;
    }
    canvas.Lines({{start, area.top}, {start, area.bottom}}, {1.5, kInk});
    canvas.Text(start, area.top - 6.0, chart.startLabel, {.size = 10.5, .color = kInk});
    canvas.Text(area.left - 12.0, area.top - 6.0, chart.valueTitle,
                {.size = 10.5, .color = kSoftInk, .place = TextPlace::LeftOf});
    PaintNotes(canvas, chart.frame, area.bottom + kAxisHeight);
}

} // namespace boxreel
