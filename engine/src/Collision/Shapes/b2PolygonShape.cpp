// SPDX-License-Identifier: MIT
#include <Box2D/Collision/Shapes/b2PolygonShape.h>

#include "../MassProperties.h"
#include "ConvexHull.h"

#include <new>

namespace
{
// Sets the bounding box of the finite points, with a minimum size of a slop per axis.
void SetAsBoxAround(b2PolygonShape* polygon, const b2Vec2* points, int32 count)
{
    b2AABB box;
    bool isEmpty = true;
    for (int32 i = 0; i < count; ++i)
    {
        if (points[i].IsValid())
        {
            box.lowerBound = isEmpty ? points[i] : b2Min(box.lowerBound, points[i]);
            box.upperBound = isEmpty ? points[i] : b2Max(box.upperBound, points[i]);
            isEmpty = false;
        }
    }
    const b2Vec2 half = b2Max(box.GetExtents(), b2Vec2(b2_linearSlop, b2_linearSlop));
    polygon->SetAsBox(half.x, half.y, box.GetCenter(), 0.0f);
}

float32 UsableHalfSize(float32 half)
{
    // The sign of a negative size is ignored.
    return b2IsValid(half) && half != 0.0f ? b2Abs(half) : b2_linearSlop;
}
} // namespace

b2Shape* b2PolygonShape::Clone(b2BlockAllocator* allocator) const
{
    return new (allocator->Allocate(sizeof(b2PolygonShape))) b2PolygonShape(*this);
}

const char* b2PolygonShape::WhyNotConvex(const b2Vec2* points, int32 count)
{
    if (points == nullptr || count < 3)
    {
        return "A polygon needs at least 3 points; give it more, or use b2EdgeShape for 2.";
    }
    if (count > b2_polygonCapacity)
    {
        static_assert(b2_polygonCapacity == 16);
        return "A polygon takes at most 16 points; split it into several fixtures.";
    }
    for (int32 i = 0; i < count; ++i)
    {
        if (!points[i].IsValid())
        {
            return "A polygon has a point that is not finite; look for NaN or an overflow.";
        }
    }
    if (box2d::ComputeConvexHull(points, count).count == 0)
    {
        return "The polygon's points lie on one line or closer together than b2_linearSlop; "
               "spread them out, or use b2EdgeShape.";
    }
    return nullptr;
}

void b2PolygonShape::Set(const b2Vec2* points, int32 count)
{
    if (const char* why = WhyNotConvex(points, count))
    {
        B2_REQUIRE(why == nullptr, why);
        SetAsBoxAround(this, points, points != nullptr ? b2Min(count, b2_polygonCapacity) : 0);
        return;
    }

    const box2d::ConvexHull hull = box2d::ComputeConvexHull(points, count);
    m_count = hull.count;
    for (int32 i = 0; i < m_count; ++i)
    {
        m_vertices[i] = hull.points[i];
        const b2Vec2 side = hull.points[(i + 1) % m_count] - hull.points[i];
        m_normals[i] = -side.Skew();
        m_normals[i].Normalize();
    }
    const box2d::MassProperties properties = box2d::ComputeMassProperties(*this, 1.0f);
    m_centroid.Set(static_cast<float32>(properties.centerX),
                   static_cast<float32>(properties.centerY));
}

void b2PolygonShape::SetAsBox(float32 hx, float32 hy)
{
    // Written so that NaN fails too.
    if (!B2_REQUIRE(hx > 0.0f && hy > 0.0f && b2IsValid(hx) && b2IsValid(hy),
                    "SetAsBox needs a positive half-width and half-height."))
    {
        hx = UsableHalfSize(hx);
        hy = UsableHalfSize(hy);
    }
    m_count = 4;
    m_vertices[0].Set(-hx, -hy);
    m_vertices[1].Set(hx, -hy);
    m_vertices[2].Set(hx, hy);
    m_vertices[3].Set(-hx, hy);
    m_normals[0].Set(0.0f, -1.0f);
    m_normals[1].Set(1.0f, 0.0f);
    m_normals[2].Set(0.0f, 1.0f);
    m_normals[3].Set(-1.0f, 0.0f);
    m_centroid.SetZero();
}

void b2PolygonShape::SetAsBox(float32 hx, float32 hy, const b2Vec2& center, float32 angle)
{
    SetAsBox(hx, hy);
    const bool isUsable = B2_REQUIRE(center.IsValid() && b2IsValid(angle),
                                     "SetAsBox got a centre or angle that is not finite.");
    const b2Transform xf = isUsable ? b2Transform(center, b2Rot(angle)) : b2Transform();
    m_centroid = xf.p;
    for (int32 i = 0; i < m_count; ++i)
    {
        m_vertices[i] = b2Mul(xf, m_vertices[i]);
        m_normals[i] = b2Mul(xf.q, m_normals[i]);
    }
}

bool b2PolygonShape::TestPoint(const b2Transform& transform, const b2Vec2& p) const
{
    const b2Vec2 local = b2MulT(transform, p);
    for (int32 i = 0; i < m_count; ++i)
    {
        if (b2Dot(m_normals[i], local - m_vertices[i]) > 0.0f)
        {
            return false;
        }
    }
    return m_count > 0;
}

// A polygon is the intersection of its half-planes. Each clips the ray p1 + t d at
//   t = n.(v - p1) / n.d
// and keeps the part after it if the ray enters (n.d < 0), before it if the ray leaves (Cyrus and
// Beck 1978). The remaining part is inside. It is a hit if it starts at an entered face within the
// ray.
bool b2PolygonShape::RayCast(b2RayCastOutput* output, const b2RayCastInput& input,
                             const b2Transform& xf, int32 childIndex) const
{
    B2_NOT_USED(childIndex);
    const b2Vec2 p1 = b2MulT(xf, input.p1);
    const b2Vec2 d = b2MulT(xf.q, input.p2 - input.p1);
    float32 enter = 0.0f;
    float32 leave = input.maxFraction;
    int32 face = -1;
    for (int32 i = 0; i < m_count; ++i)
    {
        const float32 height = b2Dot(m_normals[i], m_vertices[i] - p1);
        const float32 speed = b2Dot(m_normals[i], d);
        if (speed == 0.0f)
        {
            if (height < 0.0f)
            {
                return false;
            }
            continue;
        }
        const float32 t = height / speed;
        if (speed < 0.0f && t >= enter)
        {
            enter = t;
            face = i;
        }
        else if (speed > 0.0f)
        {
            leave = b2Min(leave, t);
        }
        if (enter > leave)
        {
            return false;
        }
    }
    if (face < 0)
    {
        return false;
    }
    output->fraction = enter;
    output->normal = b2Mul(xf.q, m_normals[face]);
    return true;
}

void b2PolygonShape::ComputeAABB(b2AABB* aabb, const b2Transform& xf, int32 childIndex) const
{
    B2_NOT_USED(childIndex);
    b2Vec2 lower = b2Mul(xf, m_vertices[0]);
    b2Vec2 upper = lower;
    for (int32 i = 1; i < m_count; ++i)
    {
        const b2Vec2 v = b2Mul(xf, m_vertices[i]);
        lower = b2Min(lower, v);
        upper = b2Max(upper, v);
    }
    const b2Vec2 r(m_radius, m_radius);
    aabb->lowerBound = lower - r;
    aabb->upperBound = upper + r;
}

void b2PolygonShape::ComputeMass(b2MassData* massData, float32 density) const
{
    B2_REQUIRE(m_count >= 3, "A polygon without corners has no mass; call Set or SetAsBox first.");
    *massData = box2d::ToMassData(box2d::ComputeMassProperties(*this, density));
}

bool b2PolygonShape::Validate() const
{
    if (m_count < 3 || m_count > b2_polygonCapacity)
    {
        return false;
    }
    for (int32 i = 0; i < m_count; ++i)
    {
        const int32 next = i + 1 < m_count ? i + 1 : 0;
        const b2Vec2 side = m_vertices[next] - m_vertices[i];
        for (int32 j = 0; j < m_count; ++j)
        {
            // Written so that NaN fails too.
            if (j != i && j != next && !(b2Cross(side, m_vertices[j] - m_vertices[i]) > 0.0f))
            {
                return false;
            }
        }
    }
    return true;
}
