// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// The convex hull of points. Used by b2PolygonShape; contains no assertions.
namespace box2d
{
struct ConvexHull
{
    b2Vec2 points[b2_polygonCapacity]; ///< counter-clockwise, the rightmost (then lowest) first
    int32 count = 0;                   ///< 0 if the points span no area
};

/// Points closer than b2_linearSlop to an earlier one, and points almost on the line between their
/// neighbours, are removed. At most b2_polygonCapacity points, all finite.
ConvexHull ComputeConvexHull(const b2Vec2* points, int32 count);
} // namespace box2d
