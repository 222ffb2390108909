// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>

/// @file
/// Convex polygons.

/// A solid convex polygon with a thin skin and 3 to b2_polygonCapacity vertices in
/// counter-clockwise order. Create it with Set or SetAsBox; treat the members as read-only.
class b2PolygonShape final : public b2Shape
{
public:
    /// Creates a polygon without vertices. b2Body::CreateFixture refuses it.
    b2PolygonShape() : b2Shape(e_polygon, b2_polygonRadius) {}

    b2Shape* Clone(b2BlockAllocator* allocator) const override;
    int32 GetChildCount() const override { return 1; } ///< always 1

    /// Sets the convex hull of 3 to b2_polygonCapacity finite points [m], in any order. Points
    /// within b2_linearSlop of another and points on the line between their neighbours are removed.
    /// Points that WhyNotConvex rejects assert; with asserts off, their bounding box is used
    /// instead.
    void Set(const b2Vec2* points, int32 count);

    /// Returns the reason why these points do not form a polygon, as a sentence; null if they do.
    static const char* WhyNotConvex(const b2Vec2* points, int32 count);

    /// Sets a box about the origin, of half-width hx and half-height hy [m], both finite and > 0.
    /// Other values assert. With asserts off, the absolute value of a negative one is used, and
    /// b2_linearSlop for any other.
    void SetAsBox(float32 hx, float32 hy);

    /// Sets a box about a centre [m], rotated by an angle [rad]. Both are finite; otherwise it
    /// asserts and uses 0.
    void SetAsBox(float32 hx, float32 hy, const b2Vec2& center, float32 angle);

    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float32 density) const override;

    int32 GetVertexCount() const { return m_count; } ///< 3 to b2_polygonCapacity
    /// Returns a vertex [m]; 0 <= index < GetVertexCount().
    const b2Vec2& GetVertex(int32 index) const
    {
        b2Assert(0 <= index && index < m_count);
        return m_vertices[index];
    }

    /// True if the polygon is convex, counter-clockwise and not degenerate. Use it after writing
    /// the members directly.
    bool Validate() const;

    b2Vec2 m_centroid;                     ///< centroid of the area [m]
    int32 m_count = 0;                     ///< number of vertices; beside them in memory
    b2Vec2 m_vertices[b2_polygonCapacity]; ///< vertices, counter-clockwise [m]
    b2Vec2 m_normals[b2_polygonCapacity];  ///< outward unit normal of the edge from vertex i to
                                           ///< i + 1
};
