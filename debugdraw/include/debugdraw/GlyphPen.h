// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <initializer_list>

/// @file
/// Draws small signs whose size is given in pixels, at a place and in a direction of the world, so
/// that they read at any zoom. Points are in pixels along the sign's own axes, x along the given
/// direction, y a quarter turn to the left of it. Angles are counted in steps of 15 degrees, whose
/// sines are written down: every machine draws the same.
namespace boxreel
{

/// Draws small signs whose size is in pixels into a list.
class GlyphPen
{
public:
    /// A place in the picture [px].
    struct Point
    {
        double x = 0.0; ///< from the left [px]
        double y = 0.0; ///< from above [px]
    };
    static constexpr int kFullTurn = 24; ///< steps

    /// `origin` in metres; `xAxis` of any length, (1, 0) is meant when it has none. What is drawn
    /// gets the layer and the owner that the list has at the time.
    GlyphPen(DrawList& list, const Camera& camera, Vec2 origin, Vec2 xAxis, const Paint& paint);

    /// In the world [m].
    Vec2 At(Point p) const;
    /// In pixels, along the sign's axes.
    Point Of(Vec2 world) const;

    /// A line from one to the other.
    void Line(Point from, Point to);
    /// From each to the next.
    void Lines(std::initializer_list<Point> points);
    /// Every other stretch of about 5 px.
    void Dashes(Point from, Point to);
    /// An outline, radius [px].
    void Circle(Point center, double radius);
    /// A filled disc, diameter [px].
    void Dot(Point center, double diameter);
    /// The outline of an upright box [px].
    void Box(Point center, double halfWidth, double halfHeight);
    /// Filled; corners counter-clockwise.
    void Triangle(Point a, Point b, Point c);
    /// A filled quarter of a disc around the origin, from 90 degrees times `quarter` on.
    void Quarter(double radius, int quarter);
    /// Around the origin, from step to step, the shorter number first; an arrow head at the end, or
    /// at the beginning when `clockwise`.
    void ArcArrow(double radius, int from, int to, bool clockwise);
    /// A spring: a straight lead, eight turns, a straight lead.
    void Zigzag(Point from, Point to, double halfWidth);

    /// The unit vector of so many steps.
    static Point Direction(int step);

private:
    DrawList& m_list;
    double m_metersPerPixel;
    Vec2 m_origin;
    Point m_axis; // unit, in the world
    Paint m_paint;
};

} // namespace boxreel
