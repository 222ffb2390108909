// SPDX-License-Identifier: MIT
#include "Manifolds.h"

namespace box2d
{
float32 CollideCircles(b2Manifold* manifold, const b2CircleShape& circleA,
                       const b2CircleShape& circleB, const b2Transform& bInA)
{
    const float32 radius = circleA.m_radius + circleB.m_radius;
    const b2Vec2 centerB = b2Mul(bInA, circleB.m_p);
    manifold->pointCount = 0;
    const float32 squared = b2DistanceSquared(circleA.m_p, centerB);
    if (squared > radius * radius)
    {
        return b2Sqrt(squared) - radius;
    }
    manifold->type = b2Manifold::e_circles;
    manifold->localPoint = circleA.m_p;
    manifold->localNormal.SetZero();
    manifold->pointCount = 1;
    manifold->points[0] = b2ManifoldPoint();
    manifold->points[0].localPoint = circleB.m_p;
    return 0.0f;
}
} // namespace box2d

void b2CollideCircles(b2Manifold* manifold, const b2CircleShape* circleA, const b2Transform& xfA,
                      const b2CircleShape* circleB, const b2Transform& xfB)
{
    box2d::CollideCircles(manifold, *circleA, *circleB, b2MulT(xfA, xfB));
}
