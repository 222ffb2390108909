// SPDX-License-Identifier: MIT
#include "ChartLabels.h"
#include "ChartParts.h"

#include <algorithm>

namespace boxreel
{
namespace
{

constexpr double kNumbersWidth = 74.0; // left of the plot
constexpr double kLabelSize = 11.0;
constexpr double kAscent = 9.0; // of letters above the line that they stand on
constexpr double kLabelHeight = 12.0;
constexpr double kRimHeight = 12.0; // between the upper edge and what lies beyond all numbers
constexpr double kRowHeight = 25.0; // of the points below the axis: a mark and a word
constexpr double kRoom = 1.05;      // times the largest value, on a logarithmic axis
constexpr ChartColor kTint{0.925, 0.965, 0.94};

using Place = std::pair<double, double>;

class LinePainter
{
public:
    LinePainter(ChartCanvas& canvas, const LineChart& chart, const PlotArea& area)
        : m_canvas(canvas), m_chart(chart), m_rows(RowsOf(chart)), m_area(area),
          m_floor(area.bottom - (m_rows.empty() ? 0.0 : kRowHeight * double(m_rows.size()) + 4.0)),
          m_across(chart.x, Values(true), area.left, area.right),
          m_upward(chart.y, Values(false), m_floor,
                   area.top + (HasBeyond() ? 2.0 * kRimHeight : 0.0)),
          m_layout({area.left, area.top, chart.frame.width - kMargin + 6.0, area.bottom})
    {}

    void Paint()
    {
        PaintGround();
        for (auto line = m_chart.lines.rbegin(); line != m_chart.lines.rend(); ++line)
        {
            PaintLine(*line);
        }
        for (auto line = m_chart.lines.rbegin(); line != m_chart.lines.rend(); ++line)
        {
            PaintMarks(*line);
        }
        PaintRules();
        for (const bool optional : {false, true})
        {
            for (const ChartLine& line : m_chart.lines)
            {
                PaintLabels(line, optional);
            }
        }
    }

private:
    static std::vector<int> RowsOf(const LineChart& chart)
    {
        std::vector<int> rows;
        for (const ChartLine& line : chart.lines)
        {
            const bool any = std::any_of(line.points.begin(), line.points.end(),
                                         [&](const auto& point) { return point.y <= chart.floor; });
            if (any && std::find(rows.begin(), rows.end(), line.series.color) == rows.end())
            {
                rows.push_back(line.series.color);
            }
        }
        return rows;
    }
    std::vector<double> Values(bool across) const
    {
        std::vector<double> values;
        for (const ChartLine& line : m_chart.lines)
        {
            for (const ChartPoint& point : line.points)
            {
                values.push_back(across ? point.x : point.y <= m_chart.floor ? kNoValue : point.y);
            }
        }
        for (const ChartRule& rule : m_chart.rules)
        {
            const bool isBelow = !rule.upright && rule.value <= m_chart.floor;
            values.push_back(rule.upright == across && !isBelow ? rule.value : kNoValue);
        }
        if ((across ? m_chart.x : m_chart.y).logarithmic)
        {
            AppendRoom(values);
        }
        if (!across && std::isfinite(m_chart.floor))
        {
            values.push_back(m_chart.floor);
            std::replace_if(
                values.begin(), values.end(), [&](double value) { return value < m_chart.floor; },
                m_chart.floor);
        }
        return values;
    }
    /// So that no mark lies on the frame.
    static void AppendRoom(std::vector<double>& values)
    {
        double low = kNoValue, high = kNoValue;
        for (const double value : values)
        {
            low = std::fmin(low, value); // passes over what is no number
            high = std::fmax(high, value);
        }
        values.push_back(low / kRoom);
        values.push_back(high * kRoom);
    }
    bool HasBeyond() const
    {
        return std::any_of(m_chart.lines.begin(), m_chart.lines.end(), [](const ChartLine& line) {
            return std::any_of(line.points.begin(), line.points.end(),
                               [](const ChartPoint& point) { return !std::isfinite(point.y); });
        });
    }
    Place At(const ChartPoint& point, int color) const
    {
        return {m_across.At(point.x), HeightOf(point, color)};
    }
    double HeightOf(const ChartPoint& point, int color) const
    {
        if (point.y <= m_chart.floor)
        {
            const auto row = std::find(m_rows.begin(), m_rows.end(), color) - m_rows.begin();
            return m_floor + kRowHeight * (double(row) + 0.72);
        }
        return std::isfinite(point.y) ? m_upward.At(point.y) : m_area.top + kRimHeight;
    }
    double RuleHeight(const ChartRule& rule) const
    {
        return rule.value <= m_chart.floor ? m_floor : m_upward.At(rule.value);
    }
    /// The value of the first rule of that direction as a place, or `otherwise`.
    double RuleAt(bool upright, double otherwise) const
    {
        for (const ChartRule& rule : m_chart.rules)
        {
            if (rule.upright == upright)
            {
                return upright ? m_across.At(rule.value) : RuleHeight(rule);
            }
        }
        return otherwise;
    }

    void PaintGround()
    {
        if (m_chart.tintsCorner)
        {
            const double top = RuleAt(false, m_area.top);
            m_canvas.Rectangle(m_area.left, top, RuleAt(true, m_area.right) - m_area.left,
                               m_area.bottom - top, kTint);
        }
        PaintAcross(m_canvas, m_chart.x, m_across, m_area);
        PaintUpward(m_canvas, m_chart.y, m_upward,
                    {m_area.left, m_area.top, m_area.right, m_floor});
        if (!m_rows.empty())
        {
            m_canvas.Lines({{m_area.left, m_floor}, {m_area.right, m_floor}}, {1.0, kInk});
            m_canvas.Text(m_area.left - 8.0, 0.5 * (m_floor + m_area.bottom) + 4.0,
                          m_chart.floorText,
                          {.size = kLabelSize, .color = kInk, .place = TextPlace::LeftOf});
        }
        m_canvas.Lines({{m_area.left, m_area.top},
                        {m_area.left, m_area.bottom},
                        {m_area.right, m_area.bottom}},
                       {1.5, kInk});
        for (const ChartRule& rule : m_chart.rules)
        {
            m_canvas.Lines(EndsOf(rule), {1.4, kInk, ChartStroke::Dashed});
        }
    }
    std::vector<Place> EndsOf(const ChartRule& rule) const
    {
        const double at = rule.upright ? m_across.At(rule.value) : RuleHeight(rule);
        return rule.upright ? std::vector<Place>{{at, m_area.top}, {at, m_area.bottom}}
                            : std::vector<Place>{{m_area.left, at}, {m_area.right, at}};
    }

    void PaintLine(const ChartLine& line)
    {
        if (line.series.stroke == ChartStroke::None)
        {
            return;
        }
        std::vector<Place> places;
        for (const ChartPoint& point : line.points)
        {
            places.push_back(At(point, line.series.color));
        }
        m_canvas.Lines(places, {2.0, SeriesColor(line.series.color), line.series.stroke});
        for (std::size_t i = 1; i < places.size(); ++i)
        {
            m_layout.AvoidLine(places[i - 1].first, places[i - 1].second, places[i].first,
                               places[i].second);
        }
    }

    void PaintMarks(const ChartLine& line)
    {
        for (const ChartPoint& point : line.points)
        {
            const auto [x, y] = At(point, line.series.color);
            PaintMark(m_canvas, point.mark, x, y, SeriesColor(line.series.color));
            const bool isSpeck = point.mark == ChartMark::Speck;
            m_layout.AvoidMark(x, y,
                               isSpeck                         ? 1.5
                               : point.mark == ChartMark::Ring ? 7.0
                                                               : 4.0,
                               isSpeck ? 0.04 : 1.0);
        }
    }

    void PaintRules()
    {
        for (const ChartRule& rule : m_chart.rules)
        {
            const std::vector<Place> ends = EndsOf(rule);
            m_layout.AvoidLine(ends[0].first, ends[0].second, ends[1].first, ends[1].second);
        }
        for (const ChartRule& rule : m_chart.rules)
        {
            const Place at = EndsOf(rule).front();
            const double width = Width(rule.label);
            std::vector<LabelBox> places;
            constexpr int kSteps = 12;
            for (int step = 0; step <= kSteps; ++step)
            {
                const double share = double(step) / kSteps;
                if (rule.upright)
                {
                    const double y = m_area.top + 4.0 + share * (m_area.bottom - m_area.top - 24.0);
                    const bool fits = at.first + 6.0 + width < m_area.right;
                    const double x = fits ? at.first + 6.0 : at.first - 6.0 - width;
                    places.push_back({x, y, x + width, y + kLabelHeight});
                    const double other = at.first - 6.0 - width;
                    places.push_back({other, y, other + width, y + kLabelHeight});
                }
                else
                {
                    const double x =
                        m_area.right - 4.0 - width - share * (m_area.right - m_area.left - width);
                    places.push_back(
                        {x, at.second - 3.0 - kLabelHeight, x + width, at.second - 3.0});
                    places.push_back(
                        {x, at.second + 3.0, x + width, at.second + 3.0 + kLabelHeight});
                }
            }
            Write(m_layout.PlaceAtOneOf(places), rule.label, kInk);
        }
    }

    void PaintLabels(const ChartLine& line, bool optional)
    {
        const ChartColor color = SeriesColor(line.series.color);
        for (const ChartPoint& point : line.points)
        {
            if (point.label.empty() || point.mayLackLabel != optional)
            {
                continue;
            }
            const auto [x, y] = At(point, line.series.color);
            const std::optional<LabelBox> box =
                m_layout.PlaceBeside(x, y, Width(point.label), kLabelHeight, optional);
            if (box)
            {
                PaintPointer(*box, x, y, color);
                Write(*box, point.label, color);
            }
        }
    }

    /// From a word that stands too far away to the point that it belongs to.
    void PaintPointer(const LabelBox& box, double x, double y, const ChartColor& color)
    {
        const double nearX = std::clamp(x, box.left, box.right);
        const double nearY = std::clamp(y, box.top + 2.0, box.bottom - 2.0);
        const double distance = std::hypot(nearX - x, nearY - y);
        if (distance > 15.0)
        {
            const double share = 5.0 / distance;
            m_canvas.Lines({{x + share * (nearX - x), y + share * (nearY - y)}, {nearX, nearY}},
                           {0.8, color});
        }
    }

    double Width(const std::string& text) { return m_canvas.TextWidth(text, {.size = kLabelSize}); }
    void Write(const LabelBox& box, const std::string& text, const ChartColor& color)
    {
        m_canvas.Text(box.left, box.top + kAscent + 1.0, text,
                      {.size = kLabelSize, .color = color});
    }

    ChartCanvas& m_canvas;
    const LineChart& m_chart;
    std::vector<int> m_rows; ///< the colours of the points below the axis, from above
    PlotArea m_area;
    double m_floor; ///< where the axis ends
    ChartScale m_across, m_upward;
    LabelLayout m_layout;
};

/// What the last points of lines need to their right.
double LabelRoom(ChartCanvas& canvas, const LineChart& chart)
{
    double widest = 0.0;
    for (const ChartLine& line : chart.lines)
    {
        const std::string label = line.points.empty() ? "" : line.points.back().label;
        widest = std::max(widest, canvas.TextWidth(label, {.size = kLabelSize}));
    }
    return widest > 0.0 ? widest + 10.0 : 0.0;
}

} // namespace

double HeightOf(const LineChart& chart)
{
    return chart.height;
}

void Paint(ChartCanvas& canvas, const LineChart& chart)
{
    std::vector<LegendEntry> legend = chart.legend;
    for (const ChartLine& line : chart.lines)
    {
        if (chart.legend.empty())
        {
            legend.push_back({line.series, LegendKey::Line});
        }
    }
    const double head = PaintHead(canvas, chart.frame, legend);
    const PlotArea area{kMargin + kNumbersWidth, std::max(head, 60.0),
                        chart.frame.width - kMargin - LabelRoom(canvas, chart),
                        chart.height - kMargin - NotesHeight(chart.frame) - kAxisHeight};
    LinePainter(canvas, chart, area).Paint();
    PaintNotes(canvas, chart.frame, area.bottom + kAxisHeight);
}

} // namespace boxreel
