// SPDX-License-Identifier: MIT
#include "Convex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boxreel
{
namespace
{

// Corners closer than this [px] are merged: far below what a pixel shows, far above the rounding of
// doubles.
constexpr double kSameCorner = 1e-6;

/// Returns the outward normal of the edge that starts at corner i.
Point EdgeNormal(const Convex& polygon, std::size_t i)
{
    const Point edge = polygon.corners[(i + 1) % polygon.count] - polygon.corners[i];
    const double length = Length(edge);
    return {edge.y / length, -edge.x / length};
}

/// Keeps the part with Dot(normal, p) <= offset.
Convex Cut(const Convex& polygon, Point normal, double offset)
{
    Convex kept;
    for (std::size_t i = 0; i < polygon.count; ++i)
    {
        const Point a = polygon.corners[i];
        const Point b = polygon.corners[(i + 1) % polygon.count];
        const double outsideA = Dot(normal, a) - offset;
        const double outsideB = Dot(normal, b) - offset;
        if (outsideA <= 0.0)
        {
            kept.Add(a);
        }
        if ((outsideA < 0.0 && outsideB > 0.0) || (outsideA > 0.0 && outsideB < 0.0))
        {
            kept.Add(a + (outsideA / (outsideA - outsideB)) * (b - a));
        }
    }
    return kept;
}

} // namespace

double Length(Point a)
{
    return std::sqrt(Dot(a, a));
}

void Convex::Add(Point corner)
{
    if (count < corners.size())
    {
        corners[count++] = corner;
    }
}

double Convex::Area() const
{
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < count; ++i)
    {
        twice += Cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    }
    return 0.5 * twice;
}

Convex MakeConvex(const Point* corners, std::size_t count)
{
    Convex polygon;
    for (std::size_t i = 0; i < count; ++i)
    {
        if (polygon.count == 0 ||
            Length(corners[i] - polygon.corners[polygon.count - 1]) > kSameCorner)
        {
            polygon.Add(corners[i]);
        }
    }
    while (polygon.count > 1 &&
           Length(polygon.corners[polygon.count - 1] - polygon.corners[0]) <= kSameCorner)
    {
        --polygon.count;
    }
    const double area = polygon.Area();
    if (std::abs(area) < kSameCorner * kSameCorner)
    {
        polygon.count = std::min<std::size_t>(polygon.count, 2);
    }
    else if (area < 0.0)
    {
        std::reverse(polygon.corners.begin(),
                     polygon.corners.begin() + std::ptrdiff_t(polygon.count));
    }
    return polygon;
}

Convex Grow(const Convex& polygon, double distance)
{
    Convex grown;
    for (std::size_t i = 0; i < polygon.count; ++i)
    {
        const Point before = EdgeNormal(polygon, (i + polygon.count - 1) % polygon.count);
        const Point after = EdgeNormal(polygon, i);
        const Point corner = polygon.corners[i];
        // The offset lines meet on the bisector of the normals, at 1 / cos(half the turn)
        // distances.
        const Point sum = before + after;
        const double cosHalf = 0.5 * Length(sum);
        if (cosHalf * kMitreLimit >= 1.0)
        {
            grown.Add(corner + (distance / (2.0 * cosHalf * cosHalf)) * sum);
            continue;
        }
        // Too far: cut perpendicular to the bisector. At a turn of 180 degrees the sum vanishes,
        // and the bisector is the direction of the first edge.
        const Point bisector = cosHalf > 1e-9 ? (0.5 / cosHalf) * sum : Point{-before.y, before.x};
        const Point across{-bisector.y, bisector.x};
        const double reach = kMitreLimit * distance;
        const double sinHalf = std::sqrt(std::max(0.0, 1.0 - cosHalf * cosHalf));
        const double side = std::max(0.0, (distance - reach * cosHalf) / sinHalf);
        if (polygon.count + 2 <= kMaxCorners)
        {
            grown.Add(corner + reach * bisector - side * across);
            grown.Add(corner + reach * bisector + side * across);
        }
        else // a large clipped polygon: its sharp corners are outside the frame
        {
            grown.Add(corner + reach * bisector);
        }
    }
    return grown;
}

Convex Shrink(const Convex& polygon, double distance)
{
    Convex rest = polygon;
    for (std::size_t i = 0; i < polygon.count && rest.count >= 3; ++i)
    {
        const Point normal = EdgeNormal(polygon, i);
        rest = Cut(rest, normal, Dot(normal, polygon.corners[i]) - distance);
    }
    if (rest.count < 3 || rest.count > kMaxCorners || rest.Area() <= 0.0)
    {
        rest.count = 0;
    }
    return rest;
}

Convex Clip(const Convex& polygon, Point lower, Point upper)
{
    Convex rest = Cut(polygon, {-1.0, 0.0}, -lower.x);
    rest = Cut(rest, {1.0, 0.0}, upper.x);
    rest = Cut(rest, {0.0, -1.0}, -lower.y);
    rest = Cut(rest, {0.0, 1.0}, upper.y);
    return MakeConvex(rest.corners.data(), rest.count);
}

// Liang and Barsky, "A New Concept and Method for Line Clipping", 1984.
std::optional<std::pair<double, double>> ClipSegment(Point a, Point b, Point lower, Point upper)
{
    const Point d = b - a;
    double first = 0.0;
    double last = 1.0;
    const double rates[4] = {-d.x, d.x, -d.y, d.y};
    const double rooms[4] = {a.x - lower.x, upper.x - a.x, a.y - lower.y, upper.y - a.y};
    for (int side = 0; side < 4; ++side)
    {
        if (rates[side] == 0.0)
        {
            if (rooms[side] < 0.0)
            {
                return std::nullopt;
            }
            continue;
        }
        const double at = rooms[side] / rates[side];
        (rates[side] < 0.0 ? first : last) =
            rates[side] < 0.0 ? std::max(first, at) : std::min(last, at);
    }
    return first <= last ? std::optional(std::pair(first, last)) : std::nullopt;
}

OrientedBox BoxAround(const Convex& polygon)
{
    OrientedBox best;
    double bestArea = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i <= polygon.count; ++i)
    {
        Point axis{1.0, 0.0};
        if (i < polygon.count)
        {
            const Point normal = EdgeNormal(polygon, i);
            axis = {-normal.y, normal.x};
        }
        Point lower{std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity()};
        Point upper{-lower.x, -lower.y};
        for (std::size_t k = 0; k < polygon.count; ++k)
        {
            const Point local{Dot(axis, polygon.corners[k]), Cross(axis, polygon.corners[k])};
            lower = {std::min(lower.x, local.x), std::min(lower.y, local.y)};
            upper = {std::max(upper.x, local.x), std::max(upper.y, local.y)};
        }
        const Point half = 0.5 * (upper - lower);
        if (half.x * half.y < bestArea)
        {
            bestArea = half.x * half.y;
            const Point middle = 0.5 * (lower + upper);
            best = {middle.x * axis + middle.y * Point{-axis.y, axis.x}, axis, half};
        }
    }
    return best;
}

double InsideDistance(const Convex& polygon, Point point)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.count; ++i)
    {
        nearest = std::min(nearest, Dot(EdgeNormal(polygon, i), polygon.corners[i] - point));
    }
    return polygon.count < 3 ? -1.0 : nearest;
}

} // namespace boxreel
