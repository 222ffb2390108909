// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>

/// @file
/// Circles.

/// A solid circle.
class b2CircleShape final : public b2Shape
{
public:
    /// Creates a circle of radius 0 at the origin.
    b2CircleShape() : b2Shape(e_circle, 0.0f) {}

    b2Shape* Clone(b2BlockAllocator* allocator) const override;
    int32 GetChildCount() const override { return 1; } ///< always 1
    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float32 density) const override;

    /// Returns 0: a circle is a point with a radius, so its one vertex supports every direction.
    int32 GetSupport(const b2Vec2& d) const
    {
        B2_NOT_USED(d);
        return 0;
    }
    /// Returns the centre [m] for every direction.
    const b2Vec2& GetSupportVertex(const b2Vec2& d) const
    {
        B2_NOT_USED(d);
        return m_p;
    }
    int32 GetVertexCount() const { return 1; } ///< always 1
    /// Returns the centre [m]; the index is 0.
    const b2Vec2& GetVertex(int32 index) const
    {
        B2_REQUIRE(index == 0, "A circle has only vertex 0.");
        return m_p;
    }

    b2Vec2 m_p; ///< the centre [m]
};
