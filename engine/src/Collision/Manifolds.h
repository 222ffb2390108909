// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>
#include <Box2D/Collision/b2Collision.h>

/// Contact manifolds from the relative transform, so that results do not depend on the distance
/// from the origin. Contacts call these with a transform computed in double precision; the public
/// b2Collide functions wrap them. Points have no impulses. Contact ids are stable from step to step
/// while the same features touch.
///
/// Where they return a gap, it is how far apart the shapes are [m], and 0 if they touch or if it is
/// not known. It lessens by at most the path of B's points in A's frame, if it is positive. A
/// negative one is along a face of B, and its amount lessens by at most the path of A's points in
/// B's frame.
namespace box2d
{
/// bInA is B's frame relative to A's: b2MulT(xfA, xfB).
float32 CollideCircles(b2Manifold* manifold, const b2CircleShape& circleA,
                       const b2CircleShape& circleB, const b2Transform& bInA);
float32 CollidePolygonAndCircle(b2Manifold* manifold, const b2PolygonShape& polygonA,
                                const b2CircleShape& circleB, const b2Transform& bInA);
float32 CollidePolygons(b2Manifold* manifold, const b2PolygonShape& polygonA,
                        const b2PolygonShape& polygonB, const b2Transform& bInA);
void CollideEdgeAndCircle(b2Manifold* manifold, const b2EdgeShape& edgeA,
                          const b2CircleShape& circleB, const b2Transform& bInA);
void CollideEdgeAndPolygon(b2Manifold* manifold, const b2EdgeShape& edgeA,
                           const b2PolygonShape& polygonB, const b2Transform& bInA);
} // namespace box2d
