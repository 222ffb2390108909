// SPDX-License-Identifier: MIT
#pragma once

#include "Chart.h"

#include <string>
#include <utility>
#include <vector>

/// What the parts of a chart are painted on: points from the upper left corner, y down. The charts
/// know only this; ChartCairo.cpp makes files of it.
namespace boxreel
{

struct ChartColor
{
    double red = 0.0, green = 0.0, blue = 0.0; ///< 0 to 1
};

enum class TextPlace
{
    RightOf, ///< begins at the point
    Around,  ///< its middle is at the point
    LeftOf,  ///< ends at the point
};

struct TextStyle
{
    double size = 12.0; ///< of the letters [points]
    ChartColor color{};
    TextPlace place = TextPlace::RightOf;
    bool bold = false;
    bool upward = false; ///< read from below to above
};

struct LineStyle
{
    double width = 1.0; ///< [points]
    ChartColor color{};
    ChartStroke stroke = ChartStroke::Solid;
};

class ChartCanvas
{
public:
    virtual ~ChartCanvas() = default;

    virtual double TextWidth(const std::string& text, const TextStyle& style) = 0;
    /// `y`: the line that the letters stand on.
    virtual void Text(double x, double y, const std::string& text, const TextStyle& style) = 0;
    virtual void Lines(const std::vector<std::pair<double, double>>& points,
                       const LineStyle& style) = 0;
    virtual void Rectangle(double x, double y, double width, double height,
                           const ChartColor& color) = 0;
    virtual void Disc(double x, double y, double radius, const ChartColor& color) = 0;
};

} // namespace boxreel
