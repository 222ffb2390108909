// SPDX-License-Identifier: MIT
//
// An edge is part of a curve with an outside and an inside. Only normals of the curve may push the
// polygon. Each edge is responsible for its share of the normals. They are that of its face, and at
// a convex vertex those up to the bisector with the neighbour's face. All other normals belong to
// the neighbour or are ghost collisions, which stop a body that slides along the curve. The idea of
// testing normals on the Gauss map of the curve is Catto's ("Smooth Collision" / "Ghost
// Collisions", GDC 2020).
#include "FaceClip.h"
#include "Manifolds.h"

namespace box2d
{
namespace
{
// The polygon's face must be better by this much [m] to be chosen instead of the edge. The normal
// of a polygon that lies on the edge then does not flicker.
constexpr float32 kPreferEdge = 0.1f * b2_linearSlop;

// A vertex where the curve turns by less than this (sine of the angle) counts as flat. An edge of
// 1 m then ends a fifth of the slop off the line of its neighbour. Rounding of vertices 1 km out
// turns it by less than a tenth as much. See docs/notes/tuned-constants.md.
constexpr float32 kFlatTurn = 1.0e-3f;

// The two edges at a convex vertex both answer for normals this near the middle (a difference of
// cosines). Rounding then leaves none without an answer. Rounding of unit vectors is
// below a millionth. At a corner of 90 degrees the shared range is 0.7 mrad wide on either side.
constexpr float32 kShared = 1.0e-3f;

// A polygon's side may extend beyond the edge by this much [m], so that a corner above a shared
// vertex is not lost. Beyond that it belongs to the neighbour. From 0.02 to 0.4 slops no test of
// motion fails; with 0 one chaotic random world throws a body (one step).
constexpr float32 kSeam = 0.1f * b2_linearSlop;

// A corner meets a vertex when it is nearer than this many radii (of both shapes: 8 cm for
// polygons). That is what 4.8 m/s make of a step of 1/60 s. From farther away, pushing it out would
// be a jump.
constexpr float32 kReach = 4.0f;

// One end of the edge, seen from the polygon's side.
struct End
{
    b2Vec2 vertex;
    b2Vec2 beyond;          ///< the neighbour's other vertex
    b2Vec2 neighbourNormal; ///< of the neighbouring edge, on the polygon's side
    uint8 index;            ///< 0 for vertex 1 of the shape, 1 for vertex 2
    bool hasNeighbour;
    bool isConvex; ///< on the polygon's side
};

// The edge, oriented with the polygon on its right.
struct Oriented
{
    End start;
    End end;
    b2Vec2 normal; ///< to the right, towards the polygon
};

enum class Share
{
    e_own,       ///< the normal belongs to this edge
    e_snap,      ///< not a normal of the curve; replaced by the edge's normal
    e_neighbours ///< the normal belongs to the neighbour
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
    o.start = {edge.m_vertex1, edge.m_vertex0, b2Vec2(), 0, edge.m_hasVertex0, false};
    o.end = {edge.m_vertex2, edge.m_vertex3, b2Vec2(), 1, edge.m_hasVertex3, false};
    o.normal = RightNormal(edge.m_vertex1, edge.m_vertex2);
    // Seen from the right, a curve that turns left is convex; normals turn as directions do.
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

// The position of a point relative to a segment of the curve.
struct Side
{
    float32 distanceSquared;
    bool isRight;
};

Side SideOf(const b2Vec2& from, const b2Vec2& to, const b2Vec2& rightNormal, const b2Vec2& p)
{
    const float32 height = b2Dot(rightNormal, p - from);
    const bool isBefore = b2Dot(p - from, to - from) <= 0.0f;
    const bool isAfter = b2Dot(p - to, from - to) <= 0.0f;
    const float32 distanceSquared = isBefore  ? b2DistanceSquared(p, from)
                                    : isAfter ? b2DistanceSquared(p, to)
                                              : height * height;
    return {distanceSquared, height >= 0.0f};
}

// Returns the nearer segment. A common vertex has the same distance to both, with equal bits. The
// right side of the curve is then the union of both right sides if the vertex is convex, and their
// intersection otherwise.
Side Nearer(const Side& a, const Side& b, bool isConvex)
{
    if (a.distanceSquared != b.distanceSquared)
    {
        return a.distanceSquared < b.distanceSquared ? a : b;
    }
    return {a.distanceSquared, isConvex ? a.isRight || b.isRight : a.isRight && b.isRight};
}

// True if the point is on the right of the curve, judged by the edge and its neighbours.
bool IsRightOfCurve(const Oriented& o, const b2Vec2& p)
{
    Side side = SideOf(o.start.vertex, o.end.vertex, o.normal, p);
    if (o.start.hasNeighbour)
    {
        side = Nearer(SideOf(o.start.beyond, o.start.vertex, o.start.neighbourNormal, p), side,
                      o.start.isConvex);
    }
    if (o.end.hasNeighbour)
    {
        side = Nearer(side, SideOf(o.end.vertex, o.end.beyond, o.end.neighbourNormal, p),
                      o.end.isConvex);
    }
    return side.isRight;
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

// Returns the owner of a push along `normal`, which leans from the edge's normal towards one of the
// ends.
Share Classify(const Oriented& o, const b2Vec2& normal)
{
    const float32 lean = b2Cross(o.normal, normal); // positive: towards the end
    const End& end = lean > 0.0f ? o.end : o.start;
    if (!end.hasNeighbour)
    {
        return Share::e_own; // at a free end all directions are allowed
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

// The edge in the polygon's frame, and the polygon's face with the largest separation from it.
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

// Returns the separation of the polygon from the edge's line; `normal` is in the polygon's frame.
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
    float32 minimum = b2_maxFloat;
    for (int32 i = 0; i < polygon.m_count; ++i)
    {
        const float32 facing = b2Dot(normalInPolygon, polygon.m_normals[i]);
        if (facing < minimum)
        {
            minimum = facing;
            side = i;
        }
    }
    const int32 sideEnd = side + 1 < polygon.m_count ? side + 1 : 0;
    const b2Vec2 p = polygon.m_vertices[side];
    const b2Vec2 q = polygon.m_vertices[sideEnd];
    manifold->type = b2Manifold::e_faceA;
    ClipToFace(manifold, {o.start.vertex, o.end.vertex, o.normal, 0, o.start.index, o.end.index},
               {b2Mul(polygonInEdge, p), b2Mul(polygonInEdge, q), p, q, static_cast<uint8>(side),
                static_cast<uint8>(side), static_cast<uint8>(sideEnd)},
               kSeam, radius);
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
// Adds the deepest corner as a contact along the edge's normal. Needed when a corner meets a vertex
// head-on and lies beside both edges.
void TouchCorner(b2Manifold* manifold, const Oriented& o, const b2Vec2& normalInPolygon,
                 const b2PolygonShape& polygon, const b2Transform& polygonInEdge, float32 radius)
{
    int32 corner = 0;
    for (int32 i = 1; i < polygon.m_count; ++i)
    {
        const b2Vec2 d = polygon.m_vertices[i] - polygon.m_vertices[corner];
        corner = b2Dot(normalInPolygon, d) < 0.0f ? i : corner;
    }
    const b2Vec2 p = b2Mul(polygonInEdge, polygon.m_vertices[corner]);
    const bool isAfter = b2DistanceSquared(p, o.end.vertex) < b2DistanceSquared(p, o.start.vertex);
    const End& end = isAfter ? o.end : o.start;
    const bool isOpen = end.isConvex || !end.hasNeighbour;
    const float32 reach = kReach * radius;
    if (!isOpen || b2DistanceSquared(p, end.vertex) > reach * reach ||
        b2Dot(o.normal, p - end.vertex) > radius)
    {
        return;
    }
    manifold->type = b2Manifold::e_faceA;
    manifold->localNormal = o.normal;
    manifold->localPoint = 0.5f * (o.start.vertex + o.end.vertex);
    manifold->pointCount = 1;
    manifold->points[0] = b2ManifoldPoint();
    manifold->points[0].localPoint = polygon.m_vertices[corner];
    manifold->points[0].id.cf.indexB = static_cast<uint8>(corner);
    manifold->points[0].id.cf.typeA = b2ContactFeature::e_face;
    manifold->points[0].id.cf.typeB = b2ContactFeature::e_vertex;
}

// The answer of an edge alone: its manifold, or the neighbour that has to answer.
struct Answer
{
    Oriented oriented;
    b2Vec2 normalInB;
    Share share = Share::e_own;
    uint8 neighbour = 0; ///< the end whose neighbour answers, if it is the neighbour's
};

Answer CollideAlone(b2Manifold* manifold, const b2EdgeShape& edgeA, const b2PolygonShape& polygonB,
                    const b2Transform& bInA)
{
    Answer answer;
    manifold->pointCount = 0;
    const float32 radius = edgeA.m_radius + polygonB.m_radius;
    const Faced faced = FindPolygonFace(edgeA, polygonB, bInA);
    if (polygonB.m_count == 0 || faced.separation > radius)
    {
        return answer;
    }

    Oriented& o = answer.oriented;
    o = LookFromRight(edgeA);
    if (!IsRightOfCurve(o, b2Mul(bInA, polygonB.m_centroid)))
    {
        if (edgeA.m_oneSided)
        {
            return answer;
        }
        o = LookFromLeft(o);
    }
    answer.normalInB = b2MulT(bInA.q, o.normal);
    const float32 separation = FindEdgeSeparation(polygonB, answer.normalInB, faced.v1);
    if (separation > radius)
    {
        return answer;
    }

    const bool isPoint = o.normal == b2Vec2_zero; // an edge of zero length has no normal
    const bool isPolygonBetter = isPoint || faced.separation > separation + kPreferEdge;
    if (isPolygonBetter && !isPoint)
    {
        const b2Vec2 normal = -b2Mul(bInA.q, polygonB.m_normals[faced.face]);
        answer.share = Classify(o, normal);
        answer.neighbour = b2Cross(o.normal, normal) > 0.0f ? o.end.index : o.start.index;
    }
    if (answer.share == Share::e_neighbours)
    {
        return answer;
    }
    if (isPolygonBetter && answer.share == Share::e_own)
    {
        ClipEdgeToPolygon(manifold, edgeA, polygonB, faced, radius);
        return answer;
    }
    ClipPolygonToEdge(manifold, o, answer.normalInB, polygonB, bInA, radius);
    if (manifold->pointCount == 0 && !isPolygonBetter)
    {
        TouchCorner(manifold, o, answer.normalInB, polygonB, bInA, radius);
    }
    return answer;
}

b2EdgeShape NeighbourAt(const b2EdgeShape& edge, uint8 end)
{
    b2EdgeShape neighbour;
    neighbour.m_radius = edge.m_radius;
    if (end == 0)
    {
        neighbour.Set(edge.m_vertex0, edge.m_vertex1);
        neighbour.m_vertex3 = edge.m_vertex2;
        neighbour.m_hasVertex3 = true;
    }
    else
    {
        neighbour.Set(edge.m_vertex2, edge.m_vertex3);
        neighbour.m_vertex0 = edge.m_vertex1;
        neighbour.m_hasVertex0 = true;
    }
    neighbour.m_oneSided = edge.m_oneSided;
    return neighbour;
}
} // namespace

void CollideEdgeAndPolygon(b2Manifold* manifold, const b2EdgeShape& edgeA,
                           const b2PolygonShape& polygonB, const b2Transform& bInA)
{
    const Answer answer = CollideAlone(manifold, edgeA, polygonB, bInA);
    if (answer.share != Share::e_neighbours)
    {
        return;
    }
    // For a corner that meets the vertex head-on, each edge may assign the push to the other. Then
    // both push along their own normals.
    b2Manifold neighbours;
    CollideAlone(&neighbours, NeighbourAt(edgeA, answer.neighbour), polygonB, bInA);
    if (neighbours.pointCount == 0)
    {
        TouchCorner(manifold, answer.oriented, answer.normalInB, polygonB, bInA,
                    edgeA.m_radius + polygonB.m_radius);
    }
}
} // namespace box2d

void b2CollideEdgeAndPolygon(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                             const b2PolygonShape* polygonB, const b2Transform& xfB)
{
    box2d::CollideEdgeAndPolygon(manifold, *edgeA, *polygonB, b2MulT(xfA, xfB));
}
