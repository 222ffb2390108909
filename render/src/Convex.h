// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

/// Plane geometry in pixels, in double: convex polygons made wider and narrower by half an
/// outline's width, clipped to the neighbourhood of the frame, and boxed. Used by ShapeBuilder
/// and by figures.
/// Never allocates.
namespace boxreel
{

struct Point
{
    double x = 0.0;
    double y = 0.0;
    friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
};
inline double Dot(Point a, Point b)
{
    return a.x * b.x + a.y * b.y;
}
inline double Cross(Point a, Point b)
{
    return a.x * b.y - a.y * b.x;
}
double Length(Point a);

/// Most corners that are drawn as one polygon: 8 of a shape and the 4 of the frame that may clip
/// it.
inline constexpr std::size_t kMaxCorners = 12;

/// A sharp corner's outline reaches at most this many half widths from the corner, then is cut off
/// squarely. Only corners below 60 degrees are concerned; a convex polygon has two of them at the
/// most (or three at 60).
inline constexpr double kMitreLimit = 2.0;

struct Convex
{
    std::size_t count = 0;
    std::array<Point, kMaxCorners + 2> corners{}; ///< positive area: Cross of successive edges >= 0

    void Add(Point corner);
    double Area() const;
};

/// The corners as a polygon of positive area without repeated corners; fewer than 3 when it has no
/// inside. `count` at most kMaxCorners.
Convex MakeConvex(const Point* corners, std::size_t count);

/// Each edge moved outwards by `distance` > 0, corners mitred up to kMitreLimit.
Convex Grow(const Convex& polygon, double distance);

/// Each edge moved inwards; empty when nothing is left.
Convex Shrink(const Convex& polygon, double distance);

/// What lies within [lower, upper].
Convex Clip(const Convex& polygon, Point lower, Point upper);

/// The part of a segment within a rectangle, as a range of its parameter; empty when it lies
/// outside.
std::optional<std::pair<double, double>> ClipSegment(Point a, Point b, Point lower, Point upper);

/// A rectangle of any direction; half extents along `axis` and across it.
struct OrientedBox
{
    Point center;
    Point axis{1.0, 0.0};
    Point half;
};

/// The smallest rectangle around the polygon that has one of its edges' directions, or lies
/// straight.
OrientedBox BoxAround(const Convex& polygon);

/// The distance from a point inside to the nearest edge; negative outside.
double InsideDistance(const Convex& polygon, Point point);

} // namespace boxreel
