// SPDX-License-Identifier: MIT
#include "../Common/Simd.h"
#include "FaceClip.h"
#include "Manifolds.h"

namespace box2d
{
namespace
{
// A's best face is preferred unless it is deeper by more than this [m]. Parallel sides of resting
// boxes differ only by rounding; otherwise the choice would flicker and warm starting fail. With 0,
// boxes of 0.8 m at 100 m/s lose 0.51 % of energy (4 sub-steps), where the test allows 0.5. With
// 0.4 slops ragdolls with limits do not come to rest.
constexpr float32 kPreferA = 0.1f * b2_linearSlop;

using simd::Float4;
static_assert(b2_polygonCapacity % Float4::kLanes == 0, "groups of vertices must not overhang");
static_assert(sizeof(b2Vec2) == 2 * sizeof(float), "vectors are loaded as pairs");

// Loads four vectors, starting at the given one.
void LoadVectors(const b2Vec2* from, Float4& x, Float4& y)
{
    simd::LoadPairs(&from->x, x, y);
}

// A polygon in the other's frame.
struct Seen
{
    float x[b2_polygonCapacity];
    float y[b2_polygonCapacity];
    int32 count;

    b2Vec2 Vertex(int32 i) const { return {x[i], y[i]}; }
};

Seen See(const b2PolygonShape& polygon, const b2Transform& xf)
{
    Seen seen;
    seen.count = polygon.m_count;
    const Float4 s = Float4::Set(xf.q.s);
    const Float4 c = Float4::Set(xf.q.c);
    for (int32 i = 0; i < seen.count; i += Float4::kLanes)
    {
        Float4 x;
        Float4 y;
        LoadVectors(polygon.m_vertices + i, x, y);
        (c * x - s * y + Float4::Set(xf.p.x)).Store(seen.x + i);
        (s * x + c * y + Float4::Set(xf.p.y)).Store(seen.y + i);
    }
    return seen;
}

// Returns the face with the largest separation from the other polygon: the axis of least overlap.
// Four faces are tested together; unused lanes are ignored.
int32 FindFace(const b2PolygonShape& polygon, const Seen& other, float32* separation)
{
    float deepest[b2_polygonCapacity];
    for (int32 i = 0; i < polygon.m_count; i += Float4::kLanes)
    {
        Float4 x;
        Float4 y;
        Float4 normalX;
        Float4 normalY;
        LoadVectors(polygon.m_vertices + i, x, y);
        LoadVectors(polygon.m_normals + i, normalX, normalY);
        Float4 minimum = Float4::Set(b2_maxFloat);
        for (int32 j = 0; j < other.count; ++j)
        {
            const Float4 wayX = Float4::Set(other.x[j]) - x;
            const Float4 wayY = Float4::Set(other.y[j]) - y;
            minimum = Min(minimum, normalX * wayX + normalY * wayY);
        }
        minimum.Store(deepest + i);
    }
    int32 face = 0;
    *separation = -b2_maxFloat;
    for (int32 i = 0; i < polygon.m_count; ++i)
    {
        if (deepest[i] > *separation)
        {
            *separation = deepest[i];
            face = i;
        }
    }
    return face;
}

void ClipPolygon(b2Manifold* manifold, const b2PolygonShape& reference, int32 face,
                 const b2PolygonShape& incident, const Seen& seen,
                 const b2Transform& incidentInReference, float32 radius)
{
    // The incident side is the one whose normal is most opposed to the face.
    const b2Vec2 normal = b2MulT(incidentInReference.q, reference.m_normals[face]);
    int32 side = 0;
    float32 minimum = b2_maxFloat;
    for (int32 i = 0; i < incident.m_count; ++i)
    {
        const float32 facing = b2Dot(normal, incident.m_normals[i]);
        if (facing < minimum)
        {
            minimum = facing;
            side = i;
        }
    }
    const int32 faceEnd = face + 1 < reference.m_count ? face + 1 : 0;
    const int32 sideEnd = side + 1 < incident.m_count ? side + 1 : 0;
    const ReferenceFace referenceFace = {reference.m_vertices[face], reference.m_vertices[faceEnd],
                                         reference.m_normals[face],  static_cast<uint8>(face),
                                         static_cast<uint8>(face),   static_cast<uint8>(faceEnd)};
    const IncidentSide incidentSide = {seen.Vertex(side),          seen.Vertex(sideEnd),
                                       incident.m_vertices[side],  incident.m_vertices[sideEnd],
                                       static_cast<uint8>(side),   static_cast<uint8>(side),
                                       static_cast<uint8>(sideEnd)};
    // The skins extend around the corners, so the side may extend by as much.
    ClipToFace(manifold, referenceFace, incidentSide, radius, radius);
}
} // namespace

// Convex polygons are separate if a face of one has all of the other in front (separating axis).
// Otherwise the face with the least overlap gives the normal. The opposite side of the other
// polygon, clipped to the face's width, gives the points (Catto, "Contact Manifolds", GDC 2007).
float32 CollidePolygons(b2Manifold* manifold, const b2PolygonShape& polygonA,
                        const b2PolygonShape& polygonB, const b2Transform& bInA)
{
    manifold->pointCount = 0;
    const float32 radius = polygonA.m_radius + polygonB.m_radius;
    const Seen seenB = See(polygonB, bInA);
    float32 separationA;
    const int32 faceA = FindFace(polygonA, seenB, &separationA);
    if (separationA > radius)
    {
        return separationA - radius;
    }
    const b2Transform aInB(b2MulT(bInA.q, -bInA.p), b2MulT(bInA.q, b2Rot()));
    const Seen seenA = See(polygonA, aInB);
    float32 separationB;
    const int32 faceB = FindFace(polygonB, seenA, &separationB);
    if (separationB > radius)
    {
        return radius - separationB;
    }

    if (separationB > separationA + kPreferA)
    {
        manifold->type = b2Manifold::e_faceB;
        ClipPolygon(manifold, polygonB, faceB, polygonA, seenA, aInB, radius);
    }
    else
    {
        manifold->type = b2Manifold::e_faceA;
        ClipPolygon(manifold, polygonA, faceA, polygonB, seenB, bInA, radius);
    }
    return 0.0f;
}
} // namespace box2d

void b2CollidePolygons(b2Manifold* manifold, const b2PolygonShape* polygonA, const b2Transform& xfA,
                       const b2PolygonShape* polygonB, const b2Transform& xfB)
{
    box2d::CollidePolygons(manifold, *polygonA, *polygonB, b2MulT(xfA, xfB));
}
