// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2Shape.h>

/// @file
/// Chains of edges.

/// A chain of edges, open or closed, each edge a child of its own. Used for static terrain.
/// It collides from both sides, or from the right side only. Each edge knows its neighbours, so
/// bodies slide along the chain without catching on vertices. A chain should not cross itself.
class b2ChainShape final : public b2Shape
{
public:
    b2ChainShape() : b2Shape(e_chain, b2_polygonRadius) {}
    ~b2ChainShape() override;
    /// Copies the vertices.
    b2ChainShape(const b2ChainShape& other);
    /// Copies the vertices.
    b2ChainShape& operator=(const b2ChainShape& other);

    /// Removes all vertices, so that the chain can be created again.
    void Clear();

    /// Creates a closed loop through at least 3 vertices [m]. The last vertex is connected with the
    /// first and does not repeat it. Vertices are finite and more than b2_linearSlop from their
    /// neighbours. Errors as in CreateChain.
    void CreateLoop(const b2Vec2* vertices, int32 count);

    /// Creates an open chain through at least 2 vertices [m]. Vertices are finite and more than
    /// b2_linearSlop from their neighbours. Other input asserts; so does a chain that already has
    /// vertices, which are replaced. With asserts off, vertices that are not finite or too close to
    /// the previous one are skipped. If too few remain, the chain is empty.
    void CreateChain(const b2Vec2* vertices, int32 count);

    /// Same as above, with ghost vertices [m], finite. The chain then collides on its right side
    /// only, as in 2.4.
    void CreateChain(const b2Vec2* vertices, int32 count, const b2Vec2& prevVertex,
                     const b2Vec2& nextVertex);

    /// Sets the ghost vertex before the first [m], finite. It continues another chain.
    void SetPrevVertex(const b2Vec2& prevVertex);

    /// Sets the ghost vertex after the last [m], finite. Another chain continues there.
    void SetNextVertex(const b2Vec2& nextVertex);

    b2Shape* Clone(b2BlockAllocator* allocator) const override;

    /// Returns the number of edges: vertices minus one, where a loop stores its first vertex twice.
    int32 GetChildCount() const override { return m_count > 0 ? m_count - 1 : 0; }

    /// Writes the child as an edge shape with its ghost vertices. 0 <= index < GetChildCount();
    /// otherwise it asserts and `edge` is unchanged.
    void GetChildEdge(b2EdgeShape* edge, int32 index) const;

    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    /// Meets both sides, also of a chain that stops one side only, as in 2.4. A child as an edge
    /// (GetChildEdge) meets rays from its right only.
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float32 density) const override;

    b2Vec2* m_vertices = nullptr; ///< owned, from b2Alloc
    int32 m_count = 0;            ///< number of vertices; in a loop the last equals the first
    b2Vec2 m_prevVertex;          ///< ghost vertex before the first [m]
    b2Vec2 m_nextVertex;          ///< ghost vertex after the last [m]
    bool m_hasPrevVertex = false; ///< true if m_prevVertex is set
    bool m_hasNextVertex = false; ///< true if m_nextVertex is set
    bool m_oneSided = false;      ///< true if the edges collide on their right side only

private:
    /// Copies the vertices that are finite and far enough apart, with room for one more. Copies
    /// none when fewer than `minimum` remain.
    void TakeVertices(const b2Vec2* vertices, int32 count, int32 minimum, bool isLoop);
};
