// SPDX-License-Identifier: MIT
#include <Box2D/Collision/b2Collision.h>

#include "Distance.h"

void b2WorldManifold::Initialize(const b2Manifold* manifold, const b2Transform& xfA,
                                 float32 radiusA, const b2Transform& xfB, float32 radiusB)
{
    if (manifold->pointCount == 0)
    {
        return;
    }
    if (manifold->type == b2Manifold::e_circles)
    {
        const b2Vec2 pA = b2Mul(xfA, manifold->localPoint);
        const b2Vec2 pB = b2Mul(xfB, manifold->points[0].localPoint);
        b2Vec2 d = pB - pA;
        const float32 distance = d.Normalize();
        normal = distance > 0.0f ? d : b2Vec2(1.0f, 0.0f);
        separations[0] = distance - radiusA - radiusB;
        // The midpoint of pA + radiusA n and pB - radiusB n.
        points[0] = 0.5f * (pA + pB + (radiusA - radiusB) * normal);
        return;
    }

    // A face of one shape and points of the other, whose skins extend towards the face.
    const bool isFaceA = manifold->type == b2Manifold::e_faceA;
    const b2Transform& xfFace = isFaceA ? xfA : xfB;
    const b2Transform& xfPoints = isFaceA ? xfB : xfA;
    const float32 radiusFace = isFaceA ? radiusA : radiusB;
    const float32 radiusPoints = isFaceA ? radiusB : radiusA;
    const b2Vec2 outward = b2Mul(xfFace.q, manifold->localNormal);
    const b2Vec2 plane = b2Mul(xfFace, manifold->localPoint);
    for (int32 i = 0; i < manifold->pointCount; ++i)
    {
        const b2Vec2 p = b2Mul(xfPoints, manifold->points[i].localPoint);
        const float32 height = b2Dot(p - plane, outward);
        separations[i] = height - radiusFace - radiusPoints;
        // The midpoint of the projections of p on the face's skin and on its own.
        points[i] = p + 0.5f * (radiusFace - height - radiusPoints) * outward;
    }
    normal = isFaceA ? outward : -outward;
}

namespace
{
bool HasPoint(const b2Manifold& manifold, b2ContactID id)
{
    for (int32 i = 0; i < manifold.pointCount; ++i)
    {
        if (manifold.points[i].id.key == id.key)
        {
            return true;
        }
    }
    return false;
}

void CompareStates(b2PointState* states, const b2Manifold& mine, const b2Manifold& other,
                   b2PointState ifMissing)
{
    for (int32 i = 0; i < b2_maxManifoldPoints; ++i)
    {
        states[i] = b2_nullState;
        if (i < mine.pointCount)
        {
            states[i] = HasPoint(other, mine.points[i].id) ? b2_persistState : ifMissing;
        }
    }
}
} // namespace

void b2GetPointStates(b2PointState state1[b2_maxManifoldPoints],
                      b2PointState state2[b2_maxManifoldPoints], const b2Manifold* manifold1,
                      const b2Manifold* manifold2)
{
    CompareStates(state1, *manifold1, *manifold2, b2_removeState);
    CompareStates(state2, *manifold2, *manifold1, b2_addState);
}

int32 b2ClipSegmentToLine(b2ClipVertex vOut[2], const b2ClipVertex vIn[2], const b2Vec2& normal,
                          float32 offset, int32 vertexIndexA)
{
    const float32 height[2] = {b2Dot(normal, vIn[0].v) - offset, b2Dot(normal, vIn[1].v) - offset};
    int32 count = 0;
    for (int32 i = 0; i < 2; ++i)
    {
        if (height[i] <= 0.0f)
        {
            vOut[count++] = vIn[i];
        }
    }
    const bool isCrossing =
        (height[0] < 0.0f && height[1] > 0.0f) || (height[0] > 0.0f && height[1] < 0.0f);
    if (isCrossing)
    {
        const float32 t = height[0] / (height[0] - height[1]);
        b2ClipVertex& cut = vOut[count++];
        cut.v = vIn[0].v + t * (vIn[1].v - vIn[0].v);
        cut.id.cf.indexA = static_cast<uint8>(vertexIndexA);
        cut.id.cf.indexB = vIn[0].id.cf.indexB;
        cut.id.cf.typeA = b2ContactFeature::e_vertex;
        cut.id.cf.typeB = b2ContactFeature::e_face;
    }
    return count;
}

// The ray is inside the box while it is inside both slabs (Kay and Kajiya 1986); the slab entered
// last gives the normal.
bool b2AABB::RayCast(b2RayCastOutput* output, const b2RayCastInput& input) const
{
    const b2Vec2 d = input.p2 - input.p1;
    float32 enter = -b2_maxFloat;
    float32 leave = b2_maxFloat;
    b2Vec2 normal;
    for (int32 axis = 0; axis < 2; ++axis)
    {
        const float32 p = input.p1(axis);
        if (d(axis) == 0.0f)
        {
            if (p < lowerBound(axis) || upperBound(axis) < p)
            {
                return false;
            }
            continue;
        }
        const float32 sign = d(axis) > 0.0f ? -1.0f : 1.0f;
        const float32 near = ((sign < 0.0f ? lowerBound(axis) : upperBound(axis)) - p) / d(axis);
        const float32 far = ((sign < 0.0f ? upperBound(axis) : lowerBound(axis)) - p) / d(axis);
        if (near > enter)
        {
            enter = near;
            normal.SetZero();
            normal(axis) = sign;
        }
        leave = b2Min(leave, far);
    }
    if (enter > leave || enter < 0.0f || enter > input.maxFraction)
    {
        return false;
    }
    output->fraction = enter;
    output->normal = normal;
    return true;
}

bool b2TestOverlap(const b2Shape* shapeA, int32 indexA, const b2Shape* shapeB, int32 indexB,
                   const b2Transform& xfA, const b2Transform& xfB)
{
    return box2d::TestOverlap(*shapeA, indexA, *shapeB, indexB, b2MulT(xfA, xfB));
}
