// SPDX-License-Identifier: MIT
#include <Box2D/Collision/Shapes/b2CircleShape.h>

#include "../MassProperties.h"

#include <new>

b2Shape* b2CircleShape::Clone(b2BlockAllocator* allocator) const
{
    return new (allocator->Allocate(sizeof(b2CircleShape))) b2CircleShape(*this);
}

bool b2CircleShape::TestPoint(const b2Transform& transform, const b2Vec2& p) const
{
    return b2DistanceSquared(b2MulT(transform, p), m_p) <= m_radius * m_radius;
}

// The ray p1 + t d meets the circle where |s + t d| = r, with s = p1 - centre. The quadratic's
// discriminant is r^2 d.d - (s x d)^2; this form avoids cancellation for distant rays.
bool b2CircleShape::RayCast(b2RayCastOutput* output, const b2RayCastInput& input,
                            const b2Transform& transform, int32 childIndex) const
{
    B2_NOT_USED(childIndex);
    const b2Vec2 s = (input.p1 - transform.p) - b2Mul(transform.q, m_p);
    const b2Vec2 d = input.p2 - input.p1;
    const float32 dd = d.LengthSquared();
    const float32 offset = b2Cross(s, d);
    const float32 discriminant = m_radius * m_radius * dd - offset * offset;
    if (discriminant < 0.0f || dd < b2_epsilon * b2_epsilon)
    {
        return false;
    }

    const float32 distance = -b2Dot(s, d) - b2Sqrt(discriminant); // times |d|
    if (distance < 0.0f || distance > input.maxFraction * dd)
    {
        return false;
    }
    output->fraction = distance / dd;
    output->normal = s + output->fraction * d;
    output->normal.Normalize();
    return true;
}

void b2CircleShape::ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const
{
    B2_NOT_USED(childIndex);
    const b2Vec2 center = b2Mul(transform, m_p);
    const b2Vec2 r(m_radius, m_radius);
    aabb->lowerBound = center - r;
    aabb->upperBound = center + r;
}

void b2CircleShape::ComputeMass(b2MassData* massData, float32 density) const
{
    *massData = box2d::ToMassData(box2d::ComputeMassProperties(*this, density));
}
