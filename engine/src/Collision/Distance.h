// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Distance.h>

/// Distance and overlap from the relative transform; Manifolds.h gives the reason. Called by
/// contacts and the time of impact.
namespace box2d
{
/// b2Distance in A's frame: bInA is B's frame relative to A's, and both output points are in A's
/// frame.
void ShapeDistance(b2DistanceOutput* output, b2SimplexCache* cache, const b2DistanceProxy& proxyA,
                   const b2DistanceProxy& proxyB, const b2Transform& bInA, bool useRadii);

bool TestOverlap(const b2Shape& shapeA, int32 indexA, const b2Shape& shapeB, int32 indexB,
                 const b2Transform& bInA);
} // namespace box2d
