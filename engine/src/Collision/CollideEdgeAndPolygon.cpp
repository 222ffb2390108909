// SPDX-License-Identifier: MIT
//
// An edge is part of a curve, and the curve has an outside and an inside. The polygon is pushed
// along a normal of the curve only, and each edge answers for its own share of the normals: its
// face's, and at a convex vertex those up to half-way to the neighbour's face. Everything else is
// the neighbour's to push, or would be a ghost: a push against the way of something that slides
// along the curve (Catto, "Smooth Collision" / "Ghost Collisions", GDC 2020, for the idea of
// looking at the contact's normal on the Gauss map of the curve).
#include "FaceClip.h"
#include "Manifolds.h"

namespace box2d
{
namespace
{
// The polygon's face must be better by this much [m] to be taken instead of the edge, so that the
// normal of a polygon lying on the edge does not flicker.
constexpr float32 kPreferEdge = 0.1f * b2_linearSlop;

// A vertex where the curve turns by less than this (sine of the angle) counts as flat.
constexpr float32 kFlatTurn = 1.0e-3f;

// The two edges at a convex vertex both answer for normals this near the middle (a difference of
// cosines), so that rounding leaves none to nobody.
constexpr float32 kShared = 1.0e-3f;

// One end of the edge as the polygon sees it.
struct End
{
    b2Vec2 vertex;
    b2Vec2 neighbourNormal; ///< of the edge beyond, on the polygon's side
    uint8 index;            ///< 0 for vertex 1 of the shape, 1 for vertex 2
    bool hasNeighbour;
    bool isConvex; ///< seen from the polygon
};

// The edge as the polygon sees it: with the polygon on the right of the way from start to end.
struct Oriented
{
    End start;
    End end;
    b2Vec2 normal; ///< to the right, towards the polygon
};

enum class Share
{
    e_own,       ///< the normal is this edge's
    e_snap,      ///< no normal of the curve; the edge's own takes its place
    e_neighbours ///< the neighbour answers for it
};

b2Vec2 RightNormal(const b2Vec2& from, const b2Vec2& to)
{
    b2Vec2 normal = -(to - from).Skew();
    normal.Normalize();
    return normal;
}

Oriented LookFromRight(const b2EdgeShape& edge)
{
    Oriented o;
    o.start = {edge.m_vertex1, b2Vec2(), 0, edge.m_hasVertex0, false};
    o.end = {edge.m_vertex2, b2Vec2(), 1, edge.m_hasVertex3, false};
    o.normal = RightNormal(edge.m_vertex1, edge.m_vertex2);
    // On the right, a curve that turns left is convex; the turn of directions is that of normals.
    if (o.start.hasNeighbour)
    {
        o.start.neighbourNormal = RightNormal(edge.m_vertex0, edge.m_vertex1);
        o.start.isConvex = b2Cross(o.start.neighbourNormal, o.normal) > kFlatTurn;
    }
    if (o.end.hasNeighbour)
    {
        o.end.neighbourNormal = RightNormal(edge.m_vertex2, edge.m_vertex3);
        o.end.isConvex = b2Cross(o.normal, o.end.neighbourNormal) > kFlatTurn;
    }
    return o;
}

// Is the point on the right of the curve? At a convex vertex the right side is all that is right of
// either edge, at a concave one what is right of both.
bool IsRightOfCurve(const Oriented& o, const b2Vec2& p)
{
    const bool isRight = b2Dot(o.normal, p - o.start.vertex) >= 0.0f;
    const bool isRightBefore =
        o.start.hasNeighbour ? b2Dot(o.start.neighbourNormal, p - o.start.vertex) >= 0.0f : isRight;
    const bool isRightAfter =
        o.end.hasNeighbour ? b2Dot(o.end.neighbourNormal, p - o.end.vertex) >= 0.0f : isRight;
    const bool isStartConvex = o.start.hasNeighbour && o.start.isConvex;
    const bool isEndConvex = o.end.hasNeighbour && o.end.isConvex;
    const bool own = isRight && (isStartConvex || isRightBefore) && (isEndConvex || isRightAfter);
    return own || (isStartConvex && isRightBefore) || (isEndConvex && isRightAfter);
}

Oriented LookFromLeft(const Oriented& right)
{
    Oriented o;
    o.start = right.end;
    o.end = right.start;
    o.normal = -right.normal;
    o.start.neighbourNormal = -o.start.neighbourNormal;
    o.end.neighbourNormal = -o.end.neighbourNormal;
    o.start.isConvex =
        o.start.hasNeighbour && b2Cross(o.start.neighbourNormal, o.normal) > kFlatTurn;
    o.end.isConvex = o.end.hasNeighbour && b2Cross(o.normal, o.end.neighbourNormal) > kFlatTurn;
    return o;
}

// Whose is a push along `normal`? It leans from the edge's normal towards one of the ends.
Share Classify(const Oriented& o, const b2Vec2& normal)
{
    const float32 lean = b2Cross(o.normal, normal); // positive: towards the end
    const End& end = lean > 0.0f ? o.end : o.start;
    if (!end.hasNeighbour)
    {
        return Share::e_own; // at a free end all directions are open
    }
    if (!end.isConvex)
    {
        return Share::e_snap;
    }
    const float32 beyond =
        lean > 0.0f ? b2Cross(end.neighbourNormal, normal) : b2Cross(normal, end.neighbourNormal);
    const bool isNearer = b2Dot(normal, o.normal) + kShared >= b2Dot(normal, end.neighbourNormal);
    return beyond <= 0.0f && isNearer ? Share::e_own : Share::e_neighbours;
}

// The edge in the polygon's frame, and the polygon's face that it is furthest from.
struct Faced
{
    b2Vec2 v1;
    b2Vec2 v2;
    int32 face;
    float32 separation;
};

Faced FindPolygonFace(const b2EdgeShape& edge, const b2PolygonShape& polygon,
                      const b2Transform& polygonInEdge)
{
    Faced faced = {b2MulT(polygonInEdge, edge.m_vertex1), b2MulT(polygonInEdge, edge.m_vertex2), 0,
                   -b2_maxFloat};
    for (int32 i = 0; i < polygon.m_count; ++i)
    {
        const b2Vec2 normal = polygon.m_normals[i];
        const float32 separation = b2Min(b2Dot(normal, faced.v1 - polygon.m_vertices[i]),
                                         b2Dot(normal, faced.v2 - polygon.m_vertices[i]));
        if (separation > faced.separation)
        {
            faced.separation = separation;
            faced.face = i;
        }
    }
    return faced;
}

// How deep the polygon reaches behind the edge's line; `normal` is in the polygon's frame.
float32 FindEdgeSeparation(const b2PolygonShape& polygon, const b2Vec2& normal, const b2Vec2& v1)
{
    float32 separation = b2_maxFloat;
    for (int32 i = 0; i < polygon.m_count; ++i)
    {
        separation = b2Min(separation, b2Dot(normal, polygon.m_vertices[i] - v1));
    }
    return separation;
}

void ClipPolygonToEdge(b2Manifold* manifold, const Oriented& o, const b2Vec2& normalInPolygon,
                       const b2PolygonShape& polygon, const b2Transform& polygonInEdge,
                       float32 radius)
{
    int32 side = 0;
    float32 least = b2_maxFloat;
    for (int32 i = 0; i < polygon.m_count; ++i)
    {
        const float32 facing = b2Dot(normalInPolygon, polygon.m_normals[i]);
        if (facing < least)
        {
            least = facing;
            side = i;
        }
    }
    const int32 sideEnd = side + 1 < polygon.m_count ? side + 1 : 0;
    const b2Vec2 p = polygon.m_vertices[side];
    const b2Vec2 q = polygon.m_vertices[sideEnd];
    manifold->type = b2Manifold::e_faceA;
    // What sticks out is above the neighbour, or above nothing.
    ClipToFace(manifold, {o.start.vertex, o.end.vertex, o.normal, 0, o.start.index, o.end.index},
               {b2Mul(polygonInEdge, p), b2Mul(polygonInEdge, q), p, q, static_cast<uint8>(side),
                static_cast<uint8>(side), static_cast<uint8>(sideEnd)},
               0.0f, radius);
}

void ClipEdgeToPolygon(b2Manifold* manifold, const b2EdgeShape& edge, const b2PolygonShape& polygon,
                       const Faced& faced, float32 radius)
{
    const int32 faceEnd = faced.face + 1 < polygon.m_count ? faced.face + 1 : 0;
    manifold->type = b2Manifold::e_faceB;
    ClipToFace(manifold,
               {polygon.m_vertices[faced.face], polygon.m_vertices[faceEnd],
                polygon.m_normals[faced.face], static_cast<uint8>(faced.face),
                static_cast<uint8>(faced.face), static_cast<uint8>(faceEnd)},
               {faced.v1, faced.v2, edge.m_vertex1, edge.m_vertex2, 0, 0, 1}, radius, radius);
}
} // namespace

void CollideEdgeAndPolygon(b2Manifold* manifold, const b2EdgeShape& edgeA,
                           const b2PolygonShape& polygonB, const b2Transform& bInA)
{
    manifold->pointCount = 0;
    const float32 radius = edgeA.m_radius + polygonB.m_radius;
    const Faced faced = FindPolygonFace(edgeA, polygonB, bInA);
    if (polygonB.m_count == 0 || faced.separation > radius)
    {
        return;
    }

    Oriented o = LookFromRight(edgeA);
    if (!IsRightOfCurve(o, b2Mul(bInA, polygonB.m_centroid)))
    {
        o = LookFromLeft(o);
    }
    const b2Vec2 normalInB = b2MulT(bInA.q, o.normal);
    const float32 separation = FindEdgeSeparation(polygonB, normalInB, faced.v1);
    if (separation > radius)
    {
        return;
    }

    const bool isPoint = o.normal == b2Vec2_zero; // an edge without length has no normal
    bool usePolygon = isPoint || faced.separation > separation + kPreferEdge;
    if (usePolygon && !isPoint)
    {
        const Share share = Classify(o, -b2Mul(bInA.q, polygonB.m_normals[faced.face]));
        if (share == Share::e_neighbours)
        {
            return;
        }
        usePolygon = share == Share::e_own;
    }
    if (usePolygon)
    {
        ClipEdgeToPolygon(manifold, edgeA, polygonB, faced, radius);
    }
    else
    {
        ClipPolygonToEdge(manifold, o, normalInB, polygonB, bInA, radius);
    }
}
} // namespace box2d

void b2CollideEdgeAndPolygon(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                             const b2PolygonShape* polygonB, const b2Transform& xfB)
{
    box2d::CollideEdgeAndPolygon(manifold, *edgeA, *polygonB, b2MulT(xfA, xfB));
}
