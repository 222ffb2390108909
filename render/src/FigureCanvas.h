// SPDX-License-Identifier: MIT
#pragma once

#include "Convex.h"

#include <render/Figure.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// What a figure is drawn on: lines, shapes and letters in pixels, in groups. PaintFigure decides
/// what is drawn and where, so that all formats show the same; each format is one FigureCanvas.
namespace boxreel
{

/// Letters of a line 15 px high, as the renderer's are: DejaVu Sans from 1901 above to 483 below
/// its baseline, of 2048 in its em square.
inline constexpr double kFigureLine = 15.0;                       // [px]
inline constexpr double kFigureFontSize = 15.0 * 2048.0 / 2384.0; // [px]
inline constexpr double kFigureAscent = 12.0; // from a line's top to its baseline [px]

/// Corners sharper than 60 degrees are cut off, as the renderer's; a hair more, so that those of
/// 60 are not.
inline constexpr double kFigureMitreLimit = kMitreLimit + 0.01;

struct FigureInk
{
    Color color; ///< its own opacity is not used
    double opacity = 1.0;
};

/// An outline of the theme's width, a fill, or both, the outline on top.
struct FigurePaint
{
    std::optional<FigureInk> fill;
    std::optional<FigureInk> stroke;
};

struct FigureGroup
{
    std::string id;    ///< an NCName of XML; no two of a figure have the same
    std::string title; ///< as the user wrote it; empty: none
    const char* layer = "";
};

class FigureCanvas
{
public:
    virtual ~FigureCanvas() = default;
    virtual void BeginPanel(const FigurePanel& panel) = 0;
    virtual void EndPanel() = 0;
    virtual void BeginGroup(const FigureGroup& group) = 0;
    virtual void EndGroup() = 0;

    /// Closed; corners mitred where `sharp`, else round.
    virtual void Polygon(std::span<const Point> corners, bool sharp, const FigurePaint& paint) = 0;
    virtual void Circle(Point center, double radius, const FigurePaint& paint) = 0;
    /// With round ends.
    virtual void Line(Point from, Point to, const FigureInk& ink) = 0;
    /// One line, from the left end of its baseline; valid UTF-8 without control characters.
    virtual void Text(Point at, const std::string& line, const FigureInk& ink) = 0;
};

/// Draws the panels. The ground is the canvas's own affair.
void PaintFigure(const Figure& figure, FigureCanvas& canvas);

/// What is wrong with the figure's sizes or cameras, if anything.
Result<void> CheckFigure(const Figure& figure);

} // namespace boxreel
