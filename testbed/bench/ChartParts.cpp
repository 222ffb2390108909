// SPDX-License-Identifier: MIT
#include "ChartParts.h"

#include <algorithm>
#include <iterator>

namespace boxreel
{
namespace
{

constexpr double kTitleSize = 19.0;
constexpr double kTextSize = 12.0;
constexpr double kNoteSize = 10.5;
constexpr double kLineHeight = 17.0;
constexpr double kLegendRow = 20.0;
constexpr double kKeyWidth = 26.0;

void PaintKey(ChartCanvas& canvas, const LegendEntry& entry, double x, double y)
{
    const ChartColor color = SeriesColor(entry.series.color);
    switch (entry.key)
    {
    case LegendKey::Box:
        canvas.Rectangle(x + 6.0, y - 9.0, 14.0, 10.0, color);
        break;
    case LegendKey::Line:
        canvas.Lines({{x, y - 4.0}, {x + 20.0, y - 4.0}}, {2.0, color, entry.series.stroke});
        canvas.Disc(x + 10.0, y - 4.0, 3.2, color);
        break;
    case LegendKey::Tick:
        canvas.Lines({{x + 13.0, y - 10.0}, {x + 13.0, y + 2.0}}, {2.5, kInk});
        break;
    case LegendKey::Stroke:
        canvas.Lines({{x, y - 4.0}, {x + 21.0, y - 4.0}}, {2.0, kSoftInk, entry.series.stroke});
        break;
    case LegendKey::Disc:
        canvas.Disc(x + 10.0, y - 4.0, 5.0, color);
        break;
    case LegendKey::Ring:
        PaintMark(canvas, ChartMark::Ring, x + 10.0, y - 4.0, kSoftInk);
        break;
    case LegendKey::Cross:
        PaintMark(canvas, ChartMark::Cross, x + 10.0, y - 4.0, kSoftInk);
        break;
    case LegendKey::Speck:
        PaintMark(canvas, ChartMark::Speck, x + 10.0, y - 4.0, kSoftInk);
        break;
    }
}

/// In columns of one width and rows of about one length; returns where the last row stands.
double PaintLegend(ChartCanvas& canvas, const ChartFrame& frame,
                   const std::vector<LegendEntry>& legend, double y)
{
    const TextStyle style{.size = kTextSize, .color = kInk};
    double width = 1.0;
    for (const LegendEntry& entry : legend)
    {
        width = std::max(width, kKeyWidth + canvas.TextWidth(entry.series.name, style) + 24.0);
    }
    const int count = std::max(1, int(legend.size()));
    const int most = std::max(1, int((frame.width - 2.0 * kMargin) / width));
    const int rows = (count + most - 1) / most;
    const int columns = (count + rows - 1) / rows;
    for (int i = 0; i < int(legend.size()); ++i)
    {
        const double x = kMargin + width * (i % columns);
        const int row = i / columns;
        const double base = y + kLegendRow * row;
        PaintKey(canvas, legend[std::size_t(i)], x, base);
        canvas.Text(x + kKeyWidth, base, legend[std::size_t(i)].series.name, style);
    }
    return y + kLegendRow * (rows - 1);
}

} // namespace

ChartColor SeriesColor(int color)
{
    static constexpr ChartColor kColors[] = {
        {0.00, 0.45, 0.70}, // blue
        {0.84, 0.37, 0.00}, // vermilion
        {0.00, 0.55, 0.42}, // green
        {0.72, 0.40, 0.60}, // purple
        {0.85, 0.58, 0.00}, // orange
        {0.30, 0.62, 0.83}, // sky
    };
    return kColors[static_cast<unsigned>(color) % std::size(kColors)];
}

void PaintMark(ChartCanvas& canvas, ChartMark mark, double x, double y, const ChartColor& color)
{
    const auto pale = [](double part) { return part + 0.6 * (1.0 - part); };
    switch (mark)
    {
    case ChartMark::Disc:
        canvas.Disc(x, y, 3.8, color);
        break;
    case ChartMark::Ring:
        canvas.Disc(x, y, 7.4, color);
        canvas.Disc(x, y, 5.6, kPaper);
        canvas.Disc(x, y, 3.8, color);
        break;
    case ChartMark::Cross:
        for (const double side : {-1.0, 1.0})
        {
            canvas.Lines({{x - 4.0, y - 4.0 * side}, {x + 4.0, y + 4.0 * side}}, {2.2, color});
        }
        break;
    case ChartMark::Speck:
        canvas.Disc(x, y, 1.9, {pale(color.red), pale(color.green), pale(color.blue)});
        break;
    }
}

double PaintHead(ChartCanvas& canvas, const ChartFrame& frame,
                 const std::vector<LegendEntry>& legend)
{
    double y = kMargin + 14.0;
    canvas.Text(kMargin, y, frame.title, {.size = kTitleSize, .color = kInk, .bold = true});
    if (!frame.subtitle.empty())
    {
        y += 22.0;
        canvas.Text(kMargin, y, frame.subtitle, {.size = kTextSize, .color = kSoftInk});
    }
    return PaintLegend(canvas, frame, legend, y + 27.0) + 18.0;
}

double NotesHeight(const ChartFrame& frame)
{
    return double(frame.notes.size()) * kLineHeight + (frame.notes.empty() ? 0.0 : 10.0);
}

void PaintNotes(ChartCanvas& canvas, const ChartFrame& frame, double top)
{
    double y = top + 10.0;
    for (const std::string& note : frame.notes)
    {
        canvas.Text(kMargin, y, note, {.size = kNoteSize, .color = kSoftInk});
        y += kLineHeight;
    }
}

void PaintAcross(ChartCanvas& canvas, const ChartAxis& axis, const ChartScale& scale,
                 const PlotArea& area)
{
    for (const bool named : {false, true}) // so that no fine line crosses a strong one
    {
        for (const ChartTick& tick : scale.Ticks())
        {
            if (tick.text.empty() == named)
            {
                continue;
            }
            const double x = scale.At(tick.value);
            canvas.Lines({{x, area.top}, {x, area.bottom}}, {1.0, named ? kGrid : kFineGrid});
            if (named)
            {
                canvas.Text(
                    x, area.bottom + 17.0, tick.text,
                    {.size = kTextSize - 1.0, .color = kSoftInk, .place = TextPlace::Around});
            }
        }
    }
    canvas.Text(0.5 * (area.left + area.right), area.bottom + 37.0, axis.title,
                {.size = kTextSize, .color = kInk, .place = TextPlace::Around});
}

void PaintUpward(ChartCanvas& canvas, const ChartAxis& axis, const ChartScale& scale,
                 const PlotArea& area)
{
    for (const bool named : {false, true})
    {
        for (const ChartTick& tick : scale.Ticks())
        {
            if (tick.text.empty() == named)
            {
                continue;
            }
            const double y = scale.At(tick.value);
            canvas.Lines({{area.left, y}, {area.right, y}}, {1.0, named ? kGrid : kFineGrid});
            if (named)
            {
                canvas.Text(
                    area.left - 8.0, y + 4.0, tick.text,
                    {.size = kTextSize - 1.0, .color = kSoftInk, .place = TextPlace::LeftOf});
            }
        }
    }
    canvas.Text(kMargin + 8.0, 0.5 * (area.top + area.bottom), axis.title,
                {.size = kTextSize, .color = kInk, .place = TextPlace::Around, .upward = true});
}

} // namespace boxreel
