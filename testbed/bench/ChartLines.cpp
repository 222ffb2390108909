// SPDX-License-Identifier: MIT
#include "ChartParts.h"

#include <algorithm>

namespace boxreel
{
namespace
{

constexpr double kNumbersWidth = 74.0; // left of the plot
constexpr double kLabelSize = 11.0;

std::vector<double> Coordinates(const LineChart& chart, double ChartPoint::*coordinate)
{
    std::vector<double> values;
    for (const ChartLine& line : chart.lines)
    {
        for (const ChartPoint& point : line.points)
        {
            values.push_back(point.*coordinate);
        }
    }
    return values;
}

struct Label
{
    double x, y;
    std::string text;
    ChartColor color;
};

/// Labels at about the same place would cover each other: they are moved apart, up and down, and
/// keep their order.
void Spread(std::vector<Label>& labels, double bottom)
{
    std::stable_sort(labels.begin(), labels.end(),
                     [](const Label& a, const Label& b) { return a.y < b.y; });
    constexpr double least = kLabelSize + 2.0;
    const auto meet = [](const Label& a, const Label& b) { return std::abs(a.x - b.x) < 40.0; };
    for (int pass = 0; pass < 50; ++pass)
    {
        for (Label& label : labels)
        {
            label.y = std::min(label.y, bottom);
        }
        for (std::size_t i = 1; i < labels.size(); ++i)
        {
            for (std::size_t j = 0; j < i; ++j)
            {
                const double lacking = least - (labels[i].y - labels[j].y);
                if (lacking > 0.0 && meet(labels[i], labels[j]))
                {
                    labels[i].y += 0.5 * lacking;
                    labels[j].y -= 0.5 * lacking;
                }
            }
        }
    }
}

} // namespace

double HeightOf(const LineChart& chart)
{
    return chart.height;
}

void Paint(ChartCanvas& canvas, const LineChart& chart)
{
    std::vector<LegendEntry> legend;
    double widest = 0.0;
    for (const ChartLine& line : chart.lines)
    {
        legend.push_back({line.series, LegendKey::Line});
        for (const ChartPoint& point : line.points)
        {
            widest = std::max(widest, canvas.TextWidth(point.label, {.size = kLabelSize}));
        }
    }
    const double head = PaintHead(canvas, chart.frame, legend);
    const double labelRoom = widest > 0.0 ? widest + 14.0 : 0.0;
    const PlotArea area{kMargin + kNumbersWidth, std::max(head, 60.0),
                        chart.frame.width - kMargin - labelRoom,
                        chart.height - kMargin - NotesHeight(chart.frame) - kAxisHeight};
    const ChartScale across(chart.x, Coordinates(chart, &ChartPoint::x), area.left, area.right);
    const ChartScale upward(chart.y, Coordinates(chart, &ChartPoint::y), area.bottom, area.top);
    PaintAcross(canvas, chart.x, across, area);
    PaintUpward(canvas, chart.y, upward, area);
    canvas.Lines({{area.left, area.top}, {area.left, area.bottom}, {area.right, area.bottom}},
                 {1.5, kInk, false});

    std::vector<Label> labels;
    for (const ChartLine& line : chart.lines)
    {
        const ChartColor color = SeriesColor(line.series.color);
        std::vector<std::pair<double, double>> points;
        for (const ChartPoint& point : line.points)
        {
            points.emplace_back(across.At(point.x), upward.At(point.y));
            if (!point.label.empty())
            {
                labels.push_back(
                    {points.back().first + 9.0, points.back().second + 4.0, point.label, color});
            }
        }
        canvas.Lines(points, {2.0, color, line.series.dashed});
        for (const auto& [x, y] : points)
        {
            canvas.Disc(x, y, 3.8, color);
        }
    }
    Spread(labels, area.bottom);
    for (const Label& label : labels)
    {
        canvas.Text(label.x, label.y, label.text, {.size = kLabelSize, .color = label.color});
    }
    PaintNotes(canvas, chart.frame, area.bottom + kAxisHeight);
}

} // namespace boxreel
