// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// @file
/// The distance of two convex shapes, by GJK.

class b2Shape;

/// A convex shape, or one edge of a chain, as the vertices and radius that GJK needs. The shape
/// must outlive the proxy.
struct b2DistanceProxy
{
    b2DistanceProxy() = default;
    /// Refers to the same shape.
    b2DistanceProxy(const b2DistanceProxy& other) { *this = other; }
    /// Refers to the same shape.
    b2DistanceProxy& operator=(const b2DistanceProxy& other);

    /// Refers to the shape, or to a child of a chain, 0 <= index < GetChildCount(). Another index
    /// asserts and leaves the proxy without vertices.
    void Set(const b2Shape* shape, int32 index);

    /// Returns the index of the vertex furthest in direction d, of any length; the first in a tie.
    /// The proxy must have a vertex.
    int32 GetSupport(const b2Vec2& d) const;

    /// Returns the vertex furthest in direction d [m]; as GetSupport.
    const b2Vec2& GetSupportVertex(const b2Vec2& d) const { return m_vertices[GetSupport(d)]; }

    int32 GetVertexCount() const { return m_count; } ///< 1 or more
    /// Returns a vertex [m]; 0 <= index < GetVertexCount().
    const b2Vec2& GetVertex(int32 index) const
    {
        b2Assert(0 <= index && index < m_count);
        return m_vertices[index];
    }

    b2Vec2 m_buffer[2];                 ///< storage for the vertices of an edge
    const b2Vec2* m_vertices = nullptr; ///< the shape's, or m_buffer [m]
    int32 m_count = 0;                  ///< number of vertices; 0: not set
    float32 m_radius = 0.0f;            ///< around the convex hull of the vertices [m], >= 0
};

inline int32 b2DistanceProxy::GetSupport(const b2Vec2& d) const
{
    int32 best = 0;
    float32 bestValue = b2Dot(m_vertices[0], d);
    for (int32 i = 1; i < m_count; ++i)
    {
        const float32 value = b2Dot(m_vertices[i], d);
        if (value > bestValue)
        {
            bestValue = value;
            best = i;
        }
    }
    return best;
}

/// The final simplex of b2Distance, to start the next call for the same pair. Set count to 0 before
/// the first call.
struct b2SimplexCache
{
    float32 metric = 0.0f; ///< length [m] or area [m^2] of the simplex, to detect a stale cache
    uint16 count = 0;      ///< number of vertices, 0 to 3
    uint8 indexA[3] = {};  ///< vertex indices of A
    uint8 indexB[3] = {};  ///< vertex indices of B
};

/// The input of b2Distance: two shapes and their transforms.
struct b2DistanceInput
{
    b2DistanceProxy proxyA; ///< the first shape
    b2DistanceProxy proxyB; ///< the second shape
    b2Transform transformA; ///< from its frame to the world
    b2Transform transformB; ///< from its frame to the world
    bool useRadii = false;  ///< measure from the skins instead of the cores
};

/// The output of b2Distance.
struct b2DistanceOutput
{
    b2Vec2 pointA;           ///< the closest point of A, in the world [m]
    b2Vec2 pointB;           ///< the closest point of B, in the world [m]
    float32 distance = 0.0f; ///< 0 when the shapes overlap [m]
    int32 iterations = 0;    ///< GJK iterations, >= 0
};

/// Computes the closest points of two shapes (Gilbert, Johnson and Keerthi). The cache is read and
/// written. Pointers are not null. A proxy without vertices asserts, and the distance is
/// b2_maxFloat.
void b2Distance(b2DistanceOutput* output, b2SimplexCache* cache, const b2DistanceInput* input);

// Statistics of b2Distance by the names of the 2.3 generation. They include the distances measured
// by b2TimeOfImpact and continuous collision; a step adds its own when it ends. The program may set
// them to 0. Concurrent calls from several threads are safe, but may lose counts.

extern int32 b2_gjkCalls;    ///< number of calls
extern int32 b2_gjkIters;    ///< iterations of all these calls
extern int32 b2_gjkMaxIters; ///< maximum iterations of a call
