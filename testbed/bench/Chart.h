// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

/// Pictures of numbers for reports, as plain data: what is to be seen, not where. Bars in groups,
/// or lines through points, on linear or logarithmic axes, with one look for titles, legends, axes
/// and notes. Black on white, for screens and for print. Knows nothing of benchmarks.
namespace boxreel
{

enum class ChartFormat
{
    Png, ///< two pixels a point
    Svg, ///< text as outlines, so that it looks the same everywhere
};

/// What stands around the plot.
struct ChartFrame
{
    std::string title;
    std::string subtitle;
    std::vector<std::string> notes; ///< below, a line each
    int width = 1000;               ///< [points]
};

struct ChartAxis
{
    std::string title; ///< with the unit, if there is one
    bool logarithmic = false;
};

enum class ChartStroke
{
    Solid,
    Dashed,
    Dotted,
    None, ///< points that nothing joins
};

/// One kind of bar or one line, as the legend shows it.
struct ChartSeries
{
    std::string name;
    int color = 0; ///< one of six that can be told apart, also by the colour-blind
    ChartStroke stroke = ChartStroke::Solid;
};

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

struct ChartBar
{
    double value = kNoValue; ///< kNoValue: no bar, only the label
    std::string label;       ///< beside its end
    double mark = kNoValue;  ///< a tick across the bar, such as a goal
};

struct ChartGroup
{
    std::string name;
    std::string detail;         ///< in small letters below the name
    std::string value;          ///< in a column of its own, beside the bars
    std::vector<ChartBar> bars; ///< one a series
};

/// Groups from top to bottom; bars across, from `start`, where a line stands.
struct BarChart
{
    ChartFrame frame;
    ChartAxis axis;
    double start = 0.0;
    std::string startLabel;
    std::string valueTitle; ///< over the column of the groups' values
    std::string markName;   ///< what a mark means; empty: there are none
    std::vector<ChartSeries> series;
    std::vector<ChartGroup> groups;
};

enum class ChartMark
{
    Disc,
    Ring,  ///< around a disc: to be found at once
    Cross, ///< instead of a disc: what failed
    Speck, ///< small and pale: one of many
};

struct ChartPoint
{
    double x = 0.0;
    double y = 0.0;    ///< kNoValue: beyond all numbers, drawn at the upper edge
    std::string label; ///< beside the point, where there is room
    ChartMark mark = ChartMark::Disc;
    /// Left out where it would cover something; else it is put farther away, with a thin line.
    bool mayLackLabel = false;
};

struct ChartLine
{
    ChartSeries series;
    std::vector<ChartPoint> points; ///< in the order in which they are joined
};

/// A straight line all over the plot, such as a goal.
struct ChartRule
{
    double value = 0.0;
    bool upright = false; ///< at this x, else at this y
    std::string label;    ///< on the line
};

enum class LegendKey
{
    Box,
    Line,
    Tick,   ///< of a mark on bars, whatever the colour of the series
    Stroke, ///< of a line whatever its colour
    Disc,
    Ring,
    Cross,
    Speck,
};

struct LegendEntry
{
    ChartSeries series;
    LegendKey key = LegendKey::Box;
};

struct LineChart
{
    ChartFrame frame;
    ChartAxis x, y;
    std::vector<ChartLine> lines; ///< the first in front
    std::vector<ChartRule> rules;
    std::vector<LegendEntry> legend; ///< empty: one entry a line
    bool tintsCorner = false;        ///< below the rule across and left of the upright one
    /// Points that are no higher are put below the axis, each colour in a row of its own, with
    /// `floorText` beside them, such as "0"; kNoValue: there are none.
    double floor = kNoValue;
    std::string floorText;
    int height = 640; ///< of the whole picture [points]
};

using Chart = std::variant<BarChart, LineChart>;

/// The bytes of such a file. Every value must be finite (or kNoValue) and, on a logarithmic axis,
/// above 0. An Error (Absent) when the library that draws is not installed.
Result<std::vector<std::uint8_t>> EncodeChart(const Chart& chart, ChartFormat format);

/// Loads the library that draws, which EncodeChart does too: to know before long work whether it
/// can be shown.
Result<void> PrepareCharts();

} // namespace boxreel
