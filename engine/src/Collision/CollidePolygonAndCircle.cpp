// SPDX-License-Identifier: MIT
#include "Manifolds.h"

namespace box2d
{
namespace
{
// Returns the face with the largest height of the centre above it, and that height.
int32 FindFace(const b2PolygonShape& polygon, const b2Vec2& center, float32* height)
{
    int32 face = 0;
    *height = -b2_maxFloat;
    for (int32 i = 0; i < polygon.m_count; ++i)
    {
        const float32 h = b2Dot(polygon.m_normals[i], center - polygon.m_vertices[i]);
        if (h > *height)
        {
            *height = h;
            face = i;
        }
    }
    return face;
}
} // namespace

// Above a face, the closest feature is the face, or a corner beyond its ends. The manifold is a
// face of A in both cases; at a corner its normal points to the centre. The id is the same all
// around the polygon, so that a rolling circle keeps its impulse.
float32 CollidePolygonAndCircle(b2Manifold* manifold, const b2PolygonShape& polygonA,
                                const b2CircleShape& circleB, const b2Transform& bInA)
{
    const float32 radius = polygonA.m_radius + circleB.m_radius;
    const b2Vec2 center = b2Mul(bInA, circleB.m_p);
    float32 height;
    const int32 face = FindFace(polygonA, center, &height);
    manifold->pointCount = 0;
    if (height > radius || polygonA.m_count == 0)
    {
        return b2Max(height - radius, 0.0f);
    }

    const b2Vec2 v1 = polygonA.m_vertices[face];
    const b2Vec2 v2 = polygonA.m_vertices[face + 1 < polygonA.m_count ? face + 1 : 0];
    b2Vec2 normal = polygonA.m_normals[face];
    b2Vec2 point = 0.5f * (v1 + v2);
    if (height > b2_epsilon) // a centre inside is pushed out through the face
    {
        const bool isBefore = b2Dot(center - v1, v2 - v1) <= 0.0f;
        const bool isAfter = b2Dot(center - v2, v1 - v2) <= 0.0f;
        if (isBefore || isAfter)
        {
            point = isBefore ? v1 : v2;
            normal = center - point;
            const float32 distance = normal.Normalize();
            if (distance > radius)
            {
                return distance - radius;
            }
        }
    }
    manifold->type = b2Manifold::e_faceA;
    manifold->localNormal = normal;
    manifold->localPoint = point;
    manifold->pointCount = 1;
    manifold->points[0] = b2ManifoldPoint();
    manifold->points[0].localPoint = circleB.m_p;
    return 0.0f;
}
} // namespace box2d

void b2CollidePolygonAndCircle(b2Manifold* manifold, const b2PolygonShape* polygonA,
                               const b2Transform& xfA, const b2CircleShape* circleB,
                               const b2Transform& xfB)
{
    box2d::CollidePolygonAndCircle(manifold, *polygonA, *circleB, b2MulT(xfA, xfB));
}
