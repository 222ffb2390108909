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

/// One kind of bar or one line, as the legend shows it.
struct ChartSeries
{
    std::string name;
    int color = 0; ///< one of six that can be told apart, also by the colour-blind
    bool dashed = false;
};

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

struct ChartBar
{
    double value = kNoValue; ///< kNoValue: no bar, only the label
    std::string label;       ///< beside its end
    bool doubtful = false;   ///< drawn hollow
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

struct ChartPoint
{
    double x = 0.0, y = 0.0;
    std::string label; ///< to the right of the point
};

struct ChartLine
{
    ChartSeries series;
    std::vector<ChartPoint> points; ///< in the order in which they are joined
};

struct LineChart
{
    ChartFrame frame;
    ChartAxis x, y;
    std::vector<ChartLine> lines;
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
