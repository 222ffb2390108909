// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>

/// @file
/// Convex polygons.

/// A solid convex polygon with a thin skin, of 3 to b2_maxPolygonVertices corners in
/// counter-clockwise order. Make it with Set or SetAsBox; the members are for reading.
class b2PolygonShape final : public b2Shape
{
public:
    /// Without any corners, which no fixture accepts.
    b2PolygonShape() : b2Shape(e_polygon, b2_polygonRadius) {}

    b2Shape* Clone(b2BlockAllocator* allocator) const override;
    int32 GetChildCount() const override { return 1; } ///< always 1

    /// Becomes the convex hull of the points [m], 3 to b2_maxPolygonVertices of them, finite, in
    /// whatever order they come. Points closer to another than b2_linearSlop and points on the line
    /// between their neighbours are left out. Points that WhyNotConvex objects to assert; with
    /// asserts off, the box around them takes their place.
    void Set(const b2Vec2* points, int32 count);

    /// What keeps these points from making a polygon, as a sentence; null when nothing does.
    static const char* WhyNotConvex(const b2Vec2* points, int32 count);

    /// A box about the origin, of half-width hx and half-height hy [m], both finite and > 0; else
    /// it asserts, and with asserts off a negative one loses its sign and any other is
    /// b2_linearSlop.
    void SetAsBox(float32 hx, float32 hy);

    /// A box about a centre [m], turned by an angle [rad], both finite: else it asserts and they
    /// are 0.
    void SetAsBox(float32 hx, float32 hy, const b2Vec2& center, float32 angle);

    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float32 density) const override;

    int32 GetVertexCount() const { return m_count; } ///< 3 to b2_maxPolygonVertices
    /// A corner [m]; 0 <= index < GetVertexCount().
    const b2Vec2& GetVertex(int32 index) const
    {
        b2Assert(0 <= index && index < m_count);
        return m_vertices[index];
    }

    /// Is this convex, counter-clockwise and not degenerate? For those who wrote the members.
    bool Validate() const;

    b2Vec2 m_centroid;                        ///< centre of the area [m]
    b2Vec2 m_vertices[b2_maxPolygonVertices]; ///< corners, counter-clockwise [m]
    b2Vec2 m_normals[b2_maxPolygonVertices];  ///< outward, of the side from vertex i to i + 1
    int32 m_count = 0;                        ///< of corners
};
