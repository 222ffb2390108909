// SPDX-License-Identifier: MIT
#pragma once

#include "ChartCanvas.h"
#include "ChartScale.h"

#include <vector>

/// What bar charts and line charts have in common: title, legend, axes, notes, colours.
namespace boxreel
{

constexpr ChartColor kInk{0.10, 0.10, 0.12};
constexpr ChartColor kSoftInk{0.36, 0.37, 0.40}; ///< for what is read second
constexpr ChartColor kGrid{0.86, 0.87, 0.89};
constexpr ChartColor kFineGrid{0.94, 0.945, 0.95};
constexpr ChartColor kPaper{1.0, 1.0, 1.0};
constexpr double kMargin = 28.0; ///< around everything [points]

/// Colours of Okabe and Ito, which the colour-blind can tell apart.
ChartColor SeriesColor(int color);

/// Where the plot itself lies [points].
struct PlotArea
{
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// Title, subtitle and a legend in as many rows as it needs; returns the height that they take.
double PaintHead(ChartCanvas& canvas, const ChartFrame& frame,
                 const std::vector<LegendEntry>& legend);

/// One point, at (x, y) [points].
void PaintMark(ChartCanvas& canvas, ChartMark mark, double x, double y, const ChartColor& color);

/// The notes below the plot's axis; `top` is where they begin.
void PaintNotes(ChartCanvas& canvas, const ChartFrame& frame, double top);
double NotesHeight(const ChartFrame& frame);

/// Grid lines, numbers and title of an axis below the plot, and of one on its left.
constexpr double kAxisHeight = 56.0; ///< what numbers and title take below the plot [points]
void PaintAcross(ChartCanvas& canvas, const ChartAxis& axis, const ChartScale& scale,
                 const PlotArea& area);
void PaintUpward(ChartCanvas& canvas, const ChartAxis& axis, const ChartScale& scale,
                 const PlotArea& area);

/// A chart on a canvas, and the size that it takes.
double HeightOf(const BarChart& chart);
void Paint(ChartCanvas& canvas, const BarChart& chart);
double HeightOf(const LineChart& chart);
void Paint(ChartCanvas& canvas, const LineChart& chart);

} // namespace boxreel
