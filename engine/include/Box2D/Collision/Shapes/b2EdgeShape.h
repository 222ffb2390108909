// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>

/// @file
/// Single edges.

/// A line segment that circles and polygons collide with from both sides, or from the right side
/// only. Edges never collide with edges. The ghost vertices are those of the neighbouring edges:
/// with them, bodies slide over the connection without catching.
class b2EdgeShape final : public b2Shape
{
public:
    b2EdgeShape() : b2Shape(e_edge, b2_polygonRadius) {}

    /// Sets an edge without ghost vertices between two points [m]. Coordinates are finite and
    /// within 1e15 of zero; b2Body::CreateFixture refuses others.
    void Set(const b2Vec2& v1, const b2Vec2& v2);
    void SetTwoSided(const b2Vec2& v1, const b2Vec2& v2)
    {
        Set(v1, v2);
    } ///< as Set, by the name
      ///< of 2.4
    /// Sets an edge from v1 to v2 between the ghost vertices v0 and v3 [m], as in 2.4. It collides
    /// only with circles and polygons whose centre is on its right. Rays from the left do not hit
    /// it.
    void SetOneSided(const b2Vec2& v0, const b2Vec2& v1, const b2Vec2& v2, const b2Vec2& v3);

    b2Shape* Clone(b2BlockAllocator* allocator) const override;
    int32 GetChildCount() const override { return 1; } ///< always 1
    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float32 density) const override;

    b2Vec2 m_vertex1;          ///< one end [m]
    b2Vec2 m_vertex2;          ///< the other end [m]
    b2Vec2 m_vertex0;          ///< the neighbour's vertex before m_vertex1, if m_hasVertex0 [m]
    b2Vec2 m_vertex3;          ///< the neighbour's vertex after m_vertex2, if m_hasVertex3 [m]
    bool m_hasVertex0 = false; ///< true if m_vertex0 is used
    bool m_hasVertex3 = false; ///< true if m_vertex3 is used
    bool m_oneSided = false;   ///< true if it collides on its right side only
};
