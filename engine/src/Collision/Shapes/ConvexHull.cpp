// SPDX-License-Identifier: MIT
#include "ConvexHull.h"

namespace box2d
{
namespace
{
// A corner that protrudes less than this is invisible [m]. It would split a side into two faces
// between which contacts would alternate. With 0.02 slops no test fails. With 0.4 slops a shape of
// one centimetre keeps 9 of its 16 corners.
constexpr double kFlat = 0.1 * b2_linearSlop;

double DistanceSquared(const b2Vec2& a, const b2Vec2& b)
{
    const double x = static_cast<double>(b.x) - a.x;
    const double y = static_cast<double>(b.y) - a.y;
    return x * x + y * y;
}

// Returns (a - o) x (b - o), positive when o, a, b turn left. Differences and products of
// single-precision numbers are exact in double precision, so the sign is exact.
double Turn(const b2Vec2& o, const b2Vec2& a, const b2Vec2& b)
{
    const double ox = o.x;
    const double oy = o.y;
    return (a.x - ox) * (b.y - oy) - (a.y - oy) * (b.x - ox);
}

int32 Weld(const b2Vec2* points, int32 count, b2Vec2* welded)
{
    constexpr double slop2 = static_cast<double>(b2_linearSlop) * b2_linearSlop;
    int32 kept = 0;
    for (int32 i = 0; i < count; ++i)
    {
        bool isApart = true;
        for (int32 j = 0; j < kept; ++j)
        {
            isApart = isApart && DistanceSquared(points[i], welded[j]) >= slop2;
        }
        if (isApart)
        {
            welded[kept++] = points[i];
        }
    }
    return kept;
}

// Gift wrapping (Jarvis 1973): the next corner has all other points on its left.
void Wrap(const b2Vec2* points, int32 count, ConvexHull* hull)
{
    int32 start = 0;
    for (int32 i = 1; i < count; ++i)
    {
        const bool isFurther = points[i].x > points[start].x ||
                               (points[i].x == points[start].x && points[i].y < points[start].y);
        start = isFurther ? i : start;
    }

    int32 corner = start;
    do
    {
        hull->points[hull->count++] = points[corner];
        int32 next = corner == 0 ? 1 : 0;
        for (int32 i = 0; i < count; ++i)
        {
            const double turn = Turn(points[corner], points[next], points[i]);
            const bool isBeyond = turn == 0.0 && DistanceSquared(points[corner], points[i]) >
                                                     DistanceSquared(points[corner], points[next]);
            if (i != corner && (turn < 0.0 || isBeyond))
            {
                next = i;
            }
        }
        corner = next;
    } while (corner != start && hull->count < count);
}

// Removes the flattest corner while there is one that does not protrude.
void RemoveFlatCorners(ConvexHull* hull)
{
    while (hull->count >= 3)
    {
        int32 flattest = -1;
        double minimum = kFlat;
        for (int32 i = 0; i < hull->count; ++i)
        {
            const b2Vec2& before = hull->points[(i + hull->count - 1) % hull->count];
            const b2Vec2& after = hull->points[(i + 1) % hull->count];
            const double base = std::sqrt(DistanceSquared(before, after));
            const double height = Turn(before, hull->points[i], after) / base;
            if (height < minimum)
            {
                minimum = height;
                flattest = i;
            }
        }
        if (flattest < 0)
        {
            return;
        }
        --hull->count;
        for (int32 i = flattest; i < hull->count; ++i)
        {
            hull->points[i] = hull->points[i + 1];
        }
    }
}
} // namespace

ConvexHull ComputeConvexHull(const b2Vec2* points, int32 count)
{
    b2Vec2 welded[b2_polygonCapacity];
    const int32 weldedCount = Weld(points, count, welded);
    ConvexHull hull;
    if (weldedCount >= 3)
    {
        Wrap(welded, weldedCount, &hull);
        RemoveFlatCorners(&hull);
    }
    hull.count = hull.count >= 3 ? hull.count : 0;
    return hull;
}
} // namespace box2d
