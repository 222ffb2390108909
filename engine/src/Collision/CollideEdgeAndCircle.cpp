// SPDX-License-Identifier: MIT
#include "Manifolds.h"

namespace box2d
{
namespace
{
void TouchVertex(b2Manifold* manifold, const b2Vec2& vertex, uint8 index,
                 const b2CircleShape& circle)
{
    manifold->type = b2Manifold::e_circles;
    manifold->localPoint = vertex;
    manifold->localNormal.SetZero();
    manifold->pointCount = 1;
    manifold->points[0] = b2ManifoldPoint();
    manifold->points[0].localPoint = circle.m_p;
    manifold->points[0].id.cf.indexA = index;
    manifold->points[0].id.cf.typeA = b2ContactFeature::e_vertex;
}
} // namespace

// The plane around an edge has three regions: beyond vertex 1, beyond vertex 2, and beside the
// edge. A circle beyond a vertex and beside the neighbouring edge is handled by the neighbour.
void CollideEdgeAndCircle(b2Manifold* manifold, const b2EdgeShape& edgeA,
                          const b2CircleShape& circleB, const b2Transform& bInA)
{
    manifold->pointCount = 0;
    const float32 radius = edgeA.m_radius + circleB.m_radius;
    const b2Vec2 center = b2Mul(bInA, circleB.m_p);
    const b2Vec2 v1 = edgeA.m_vertex1;
    const b2Vec2 v2 = edgeA.m_vertex2;
    const b2Vec2 e = v2 - v1;
    if (edgeA.m_oneSided && b2Cross(e, center - v1) > 0.0f)
    {
        return; // on the left
    }

    if (b2Dot(center - v1, e) <= 0.0f)
    {
        const bool isNeighbours =
            edgeA.m_hasVertex0 && b2Dot(center - v1, edgeA.m_vertex0 - v1) > 0.0f;
        if (!isNeighbours && b2DistanceSquared(center, v1) <= radius * radius)
        {
            TouchVertex(manifold, v1, 0, circleB);
        }
        return;
    }
    if (b2Dot(center - v2, e) >= 0.0f)
    {
        const bool isNeighbours =
            edgeA.m_hasVertex3 && b2Dot(center - v2, edgeA.m_vertex3 - v2) > 0.0f;
        if (!isNeighbours && b2DistanceSquared(center, v2) <= radius * radius)
        {
            TouchVertex(manifold, v2, 1, circleB);
        }
        return;
    }

    b2Vec2 normal = e.Skew();
    normal.Normalize();
    const float32 height = b2Dot(normal, center - v1);
    if (b2Abs(height) > radius)
    {
        return;
    }
    manifold->type = b2Manifold::e_faceA;
    manifold->localNormal = height < 0.0f ? -normal : normal;
    manifold->localPoint = v1;
    manifold->pointCount = 1;
    manifold->points[0] = b2ManifoldPoint();
    manifold->points[0].localPoint = circleB.m_p;
    manifold->points[0].id.cf.typeA = b2ContactFeature::e_face;
}
} // namespace box2d

void b2CollideEdgeAndCircle(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                            const b2CircleShape* circleB, const b2Transform& xfB)
{
    box2d::CollideEdgeAndCircle(manifold, *edgeA, *circleB, b2MulT(xfA, xfB));
}
