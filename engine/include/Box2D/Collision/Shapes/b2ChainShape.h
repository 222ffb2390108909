// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2Shape.h>

/// @file
/// Chains of edges.

/// Edges end to end, open or as a loop, each a child of its own: level ground. Collides from both
/// sides, or from its right alone, and knows each edge's neighbours, so bodies slide along it
/// without catching. It should not cross itself.
class b2ChainShape final : public b2Shape
{
public:
    b2ChainShape() : b2Shape(e_chain, b2_polygonRadius) {}
    ~b2ChainShape() override;
    /// With vertices of its own.
    b2ChainShape(const b2ChainShape& other);
    /// With vertices of its own.
    b2ChainShape& operator=(const b2ChainShape& other);

    /// Takes all vertices away, so that the chain can be made anew.
    void Clear();

    /// A closed loop through at least 3 vertices [m], finite and more than b2_linearSlop from their
    /// neighbours; the last is connected with the first and does not repeat it. Errors as in
    /// CreateChain.
    void CreateLoop(const b2Vec2* vertices, int32 count);

    /// An open chain through at least 2 vertices [m], finite and more than b2_linearSlop from their
    /// neighbours. Anything else asserts, and so does a chain that has vertices already, which go.
    /// With asserts off, vertices that are not finite or too close to the one before are left out,
    /// and where too few remain the chain has none.
    void CreateChain(const b2Vec2* vertices, int32 count);

    /// The same between ghost vertices [m], finite; it stops only what is on its right, as in 2.4.
    void CreateChain(const b2Vec2* vertices, int32 count, const b2Vec2& prevVertex,
                     const b2Vec2& nextVertex);

    /// The ghost vertex before the first [m], finite, to continue another chain.
    void SetPrevVertex(const b2Vec2& prevVertex);

    /// The ghost vertex after the last [m], finite, to be continued by another chain.
    void SetNextVertex(const b2Vec2& nextVertex);

    b2Shape* Clone(b2BlockAllocator* allocator) const override;

    /// The number of edges: one less than that of vertices, where a loop counts its first twice.
    int32 GetChildCount() const override { return m_count > 0 ? m_count - 1 : 0; }

    /// The child as an edge shape with its ghost vertices. 0 <= index < GetChildCount(); else it
    /// asserts, and `edge` is as it was.
    void GetChildEdge(b2EdgeShape* edge, int32 index) const;

    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    /// Meets both sides, also of a chain that stops one side only, as in 2.4. A child as an edge
    /// (GetChildEdge) meets rays from its right only.
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float32 density) const override;

    b2Vec2* m_vertices = nullptr; ///< owned, from b2Alloc
    int32 m_count = 0;            ///< of vertices; in a loop the last equals the first
    b2Vec2 m_prevVertex;          ///< ghost vertex before the first [m]
    b2Vec2 m_nextVertex;          ///< ghost vertex after the last [m]
    bool m_hasPrevVertex = false; ///< whether there is one
    bool m_hasNextVertex = false; ///< whether there is one
    bool m_oneSided = false;      ///< whether its edges stop only what is on their right

private:
    /// Copies the vertices that are finite and far enough apart, with room for one more; none when
    /// fewer than `least` remain.
    void TakeVertices(const b2Vec2* vertices, int32 count, int32 least, bool isLoop);
};
