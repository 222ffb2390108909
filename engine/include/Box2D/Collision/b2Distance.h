// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// @file
/// How far two convex shapes are apart, by GJK.

class b2Shape;

/// A convex shape, or one edge of a chain, as the vertices and radius that GJK needs. The shape
/// must outlive the proxy.
struct b2DistanceProxy
{
    b2DistanceProxy() = default;
    /// Looks at the same shape.
    b2DistanceProxy(const b2DistanceProxy& other) { *this = other; }
    /// Looks at the same shape.
    b2DistanceProxy& operator=(const b2DistanceProxy& other);

    /// Looks at the shape, or at the given child of a chain, 0 <= index < its GetChildCount(); of
    /// another it asserts, and the proxy has no vertices.
    void Set(const b2Shape* shape, int32 index);

    /// The index of the vertex furthest in direction d, of any length; of equals, the first. There
    /// is one at least.
    int32 GetSupport(const b2Vec2& d) const;

    /// The vertex furthest in direction d [m]; as GetSupport.
    const b2Vec2& GetSupportVertex(const b2Vec2& d) const { return m_vertices[GetSupport(d)]; }

    int32 GetVertexCount() const { return m_count; } ///< 1 or more
    /// A vertex [m]; 0 <= index < GetVertexCount().
    const b2Vec2& GetVertex(int32 index) const
    {
        b2Assert(0 <= index && index < m_count);
        return m_vertices[index];
    }

    b2Vec2 m_buffer[2];                 ///< the vertices of an edge
    const b2Vec2* m_vertices = nullptr; ///< the shape's, or m_buffer [m]
    int32 m_count = 0;                  ///< of vertices; 0: not set yet
    float32 m_radius = 0.0f;            ///< around the vertices' hull [m], >= 0
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

/// Where b2Distance ended, to start the next call for the same pair there. Set count to 0 before
/// the first call.
struct b2SimplexCache
{
    float32 metric = 0.0f; ///< length [m] or area [m^2] of the simplex, to tell when it is stale
    uint16 count = 0;      ///< of vertices in use, 0 to 3
    uint8 indexA[3] = {};  ///< vertices of A
    uint8 indexB[3] = {};  ///< vertices of B
};

/// Two shapes and where they are.
struct b2DistanceInput
{
    b2DistanceProxy proxyA; ///< the first shape
    b2DistanceProxy proxyB; ///< the second shape
    b2Transform transformA; ///< from its frame to the world
    b2Transform transformB; ///< from its frame to the world
    bool useRadii = false;  ///< measure from the skins rather than from the cores
};

/// What b2Distance has found.
struct b2DistanceOutput
{
    b2Vec2 pointA;           ///< the closest point of A, in the world [m]
    b2Vec2 pointB;           ///< the closest point of B, in the world [m]
    float32 distance = 0.0f; ///< 0 when they overlap [m]
    int32 iterations = 0;    ///< of GJK, 0 or more
};

/// The closest points of two shapes, by the algorithm of Gilbert, Johnson and Keerthi. The cache is
/// read and written. No pointer is null; a proxy without vertices asserts, and the distance is
/// b2_maxFloat.
void b2Distance(b2DistanceOutput* output, b2SimplexCache* cache, const b2DistanceInput* input);

// Statistics of b2Distance by the names of the 2.3 generation. They cover the calls of b2Distance
// and the distances that b2TimeOfImpact and continuous collision measure; a step adds its own when
// it ends. The program may set them to 0. Calls at the same time from several threads race for
// nothing, but may lose a count.

extern int32 b2_gjkCalls;    ///< how often a distance was measured
extern int32 b2_gjkIters;    ///< iterations of all these calls
extern int32 b2_gjkMaxIters; ///< iterations of the longest of these calls
