// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <initializer_list>

/// @file
/// Draws glyphs at a position and in a direction of the world. Their size is in pixels, so that
/// they are legible at any zoom. Points are in pixels along the glyph's axes: x along the given
/// direction, y rotated 90 degrees to the left. Angles are in steps of 15 degrees with constant
/// sines, so that every machine draws the same.
namespace boxreel
{

/// Draws glyphs with a size in pixels into a list.
class GlyphPen
{
public:
    /// A point of the glyph [px].
    struct Point
    {
        double x = 0.0; ///< along the x axis [px]
        double y = 0.0; ///< along the y axis [px]
    };
    static constexpr int kFullTurn = 24; ///< steps

    /// `origin` in metres. `xAxis` may have any length; zero stands for (1, 0). Items get the
    /// current layer and owner of the list.
    GlyphPen(DrawList& list, const Camera& camera, Vec2 origin, Vec2 xAxis, const Paint& paint);

    /// Converts to the world [m].
    Vec2 At(Point p) const;
    /// Converts from the world to pixels along the glyph's axes.
    Point Of(Vec2 world) const;

    /// Adds a line.
    void Line(Point from, Point to);
    /// Adds lines between consecutive points.
    void Lines(std::initializer_list<Point> points);
    static constexpr double kDash = 5.0; ///< length of a dash [px]
    /// Adds a line with dashes of about kDash.
    void Dashes(Point from, Point to);
    /// Adds an outline; radius [px].
    void Circle(Point center, double radius);
    /// Adds a filled disc; diameter [px].
    void Dot(Point center, double diameter);
    /// Adds the outline of a box along the axes [px].
    void Box(Point center, double halfWidth, double halfHeight);
    /// Adds a filled triangle; vertices counter-clockwise.
    void Triangle(Point a, Point b, Point c);
    /// Adds a filled quarter of a disc around the origin, starting at 90 degrees times `quarter`.
    void Quarter(double radius, int quarter);
    /// Adds an arc around the origin from the smaller step to the larger. The arrow head is at the
    /// end, or at the start if `clockwise`.
    void ArcArrow(double radius, int from, int to, bool clockwise);
    /// Adds a spring: a straight end, eight turns, a straight end.
    void Zigzag(Point from, Point to, double halfWidth);

    /// Returns the unit vector at this step.
    static Point Direction(int step);

private:
    DrawList& m_list;
    double m_metersPerPixel;
    Vec2 m_origin;
    Point m_axis; // unit, in the world
    Paint m_paint;
};

} // namespace boxreel
