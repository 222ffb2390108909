// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

/// Plane geometry in pixels, in double. Convex polygons are grown and shrunk by half an outline's
/// width, and clipped to the surroundings of the frame. Used by ShapeBuilder and by figures. Never
/// allocates.
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

/// Maximum corners of a polygon: 16 of a shape and 4 from clipping to the frame.
inline constexpr std::size_t kMaxCorners = 20;

/// Miter limit in half widths; longer corners are cut off. It affects corners below 60 degrees; a
/// convex polygon has at most two of them (or three at 60).
inline constexpr double kMitreLimit = 2.0;

struct Convex
{
    std::size_t count = 0;
    std::array<Point, kMaxCorners + 2> corners{}; ///< positive area: Cross of successive edges >= 0

    void Add(Point corner);
    double Area() const;
};

/// Returns the corners as a polygon of positive area without repeated corners; fewer than 3 if it
/// is degenerate. `count` is at most kMaxCorners.
Convex MakeConvex(const Point* corners, std::size_t count);

/// Moves each edge outwards by `distance` > 0, with corners mitred up to kMitreLimit.
Convex Grow(const Convex& polygon, double distance);

/// Moves each edge inwards; the result may be empty.
Convex Shrink(const Convex& polygon, double distance);

/// Returns the part within [lower, upper].
Convex Clip(const Convex& polygon, Point lower, Point upper);

/// Returns the part of a segment within a rectangle, as a parameter range; empty if it is outside.
std::optional<std::pair<double, double>> ClipSegment(Point a, Point b, Point lower, Point upper);

/// A rotated rectangle; half extents along `axis` and perpendicular to it.
struct OrientedBox
{
    Point center;
    Point axis{1.0, 0.0};
    Point half;
};

/// Returns the smallest enclosing rectangle that is axis-aligned or parallel to an edge.
OrientedBox BoxAround(const Convex& polygon);

/// Returns the distance from a point inside to the nearest edge; negative outside.
double InsideDistance(const Convex& polygon, Point point);

} // namespace boxreel
