// SPDX-License-Identifier: MIT
#include <Box2D/Collision/Shapes/b2EdgeShape.h>

#include "../MassProperties.h"

#include <new>

void b2EdgeShape::Set(const b2Vec2& v1, const b2Vec2& v2)
{
    m_vertex1 = v1;
    m_vertex2 = v2;
    m_hasVertex0 = false;
    m_hasVertex3 = false;
    m_oneSided = false;
}

void b2EdgeShape::SetOneSided(const b2Vec2& v0, const b2Vec2& v1, const b2Vec2& v2,
                              const b2Vec2& v3)
{
    m_vertex0 = v0;
    m_vertex1 = v1;
    m_vertex2 = v2;
    m_vertex3 = v3;
    m_hasVertex0 = true;
    m_hasVertex3 = true;
    m_oneSided = true;
}

b2Shape* b2EdgeShape::Clone(b2BlockAllocator* allocator) const
{
    return new (allocator->Allocate(sizeof(b2EdgeShape))) b2EdgeShape(*this);
}

bool b2EdgeShape::TestPoint(const b2Transform& transform, const b2Vec2& p) const
{
    B2_NOT_USED(transform);
    B2_NOT_USED(p);
    return false;
}

// The ray hits the edge if its vertices are on different sides of the ray's line. Edges with a
// common vertex compute the same number for it, so that no ray passes between them. Then
//   p1 + t d = v1 + s e   =>   t = (v1 - p1) x e / d x e
bool b2EdgeShape::RayCast(b2RayCastOutput* output, const b2RayCastInput& input,
                          const b2Transform& xf, int32 childIndex) const
{
    B2_NOT_USED(childIndex);
    const b2Vec2 p1 = b2MulT(xf, input.p1);
    const b2Vec2 d = b2MulT(xf.q, input.p2 - input.p1);
    const b2Vec2 to1 = m_vertex1 - p1;
    const b2Vec2 to2 = m_vertex2 - p1;
    const float32 side1 = b2Cross(d, to1);
    const float32 side2 = b2Cross(d, to2);
    const bool areSameSide =
        (side1 > 0.0f && side2 > 0.0f) || (side1 < 0.0f && side2 < 0.0f) || side1 == side2;
    if (areSameSide)
    {
        return false; // also if the ray is parallel to the edge, which has no thickness
    }

    const b2Vec2 e = m_vertex2 - m_vertex1;
    const float32 height = b2Cross(to1, e);
    const float32 t = height / (side2 - side1);
    const bool isFromLeft = height > 0.0f;
    if (!(t >= 0.0f && t <= input.maxFraction) || (m_oneSided && isFromLeft))
    {
        return false;
    }
    b2Vec2 normal = e.Skew();
    normal.Normalize();
    output->fraction = t;
    output->normal = b2Mul(xf.q, b2Dot(normal, d) > 0.0f ? -normal : normal);
    return true;
}

void b2EdgeShape::ComputeAABB(b2AABB* aabb, const b2Transform& xf, int32 childIndex) const
{
    B2_NOT_USED(childIndex);
    const b2Vec2 v1 = b2Mul(xf, m_vertex1);
    const b2Vec2 v2 = b2Mul(xf, m_vertex2);
    const b2Vec2 r(m_radius, m_radius);
    aabb->lowerBound = b2Min(v1, v2) - r;
    aabb->upperBound = b2Max(v1, v2) + r;
}

void b2EdgeShape::ComputeMass(b2MassData* massData, float32 density) const
{
    *massData = box2d::ToMassData(box2d::ComputeMassProperties(*this, density));
    massData->I = 0.0f;
}
