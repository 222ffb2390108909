// SPDX-License-Identifier: MIT
#pragma once

#include "Convex.h"

#include <render/Figure.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// The output interface of figures: lines, shapes and text in pixels, in groups. PaintFigure places
/// all items, so all formats show the same. Each format is one FigureCanvas.
namespace boxreel
{

/// Text in lines of 15 px, as in the renderer: DejaVu Sans from 1901 above to 483 below its
/// baseline, of 2048 in its em square.
inline constexpr double kFigureLine = 15.0;                       // [px]
inline constexpr double kFigureFontSize = 15.0 * 2048.0 / 2384.0; // [px]
inline constexpr double kFigureAscent = 12.0; // from a line's top to its baseline [px]

/// Corners sharper than 60 degrees are cut off, as in the renderer. Slightly more, so that exactly
/// 60 degrees are not.
inline constexpr double kFigureMitreLimit = kMitreLimit + 0.01;

struct FigureInk
{
    Color color; ///< alpha is not used
    double opacity = 1.0;
};

/// An outline of the theme's width, a fill, or both, with the outline on top.
struct FigurePaint
{
    std::optional<FigureInk> fill;
    std::optional<FigureInk> stroke;
};

struct FigureGroup
{
    std::string id;    ///< an NCName of XML, unique in the figure
    std::string title; ///< as the user wrote it; may be empty
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

    /// Draws a closed polygon; corners mitred if `sharp`, otherwise round.
    virtual void Polygon(std::span<const Point> corners, bool sharp, const FigurePaint& paint) = 0;
    virtual void Circle(Point center, double radius, const FigurePaint& paint) = 0;
    /// Draws a line with round ends.
    virtual void Line(Point from, Point to, const FigureInk& ink) = 0;
    /// Draws one line of text from the left end of its baseline; valid UTF-8 without control
    /// characters.
    virtual void Text(Point at, const std::string& line, const FigureInk& ink) = 0;
};

/// Draws the panels. The canvas draws the background.
void PaintFigure(const Figure& figure, FigureCanvas& canvas);

/// Returns an Error for invalid sizes or cameras.
Result<void> CheckFigure(const Figure& figure);

} // namespace boxreel
