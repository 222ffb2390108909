// SPDX-License-Identifier: MIT
#include "FaceClip.h"

namespace box2d
{
namespace
{
struct End
{
    float32 t;       ///< parameter on the incident side, 0 at p and 1 at q
    uint8 reference; ///< feature of the point: the face with an incident vertex, or a vertex of the
                     ///< face with the incident side
    uint8 incident;
    bool isCut;
};

b2ContactID MakeId(const End& end, bool isFaceA)
{
    const uint8 vertex = b2ContactFeature::e_vertex;
    const uint8 face = b2ContactFeature::e_face;
    b2ContactID id;
    id.cf.indexA = isFaceA ? end.reference : end.incident;
    id.cf.indexB = isFaceA ? end.incident : end.reference;
    id.cf.typeA = end.isCut == isFaceA ? vertex : face;
    id.cf.typeB = end.isCut == isFaceA ? face : vertex;
    return id;
}

// Moves an end outside the face's width [low, high] to its border. x is the end's coordinate along
// the face, otherX that of the other end. False if the whole side is outside.
bool Cut(End* end, float32 x, float32 otherX, float32 low, float32 high, const ReferenceFace& face,
         uint8 incidentFace)
{
    const bool isBefore = x < low;
    if (!isBefore && x <= high)
    {
        return true;
    }
    const float32 border = isBefore ? low : high;
    if (isBefore ? otherX < low : otherX > high)
    {
        return false;
    }
    const float32 fraction = (border - x) / (otherX - x);
    end->t = end->t == 0.0f ? fraction : 1.0f - fraction;
    end->reference = isBefore ? face.vertex1 : face.vertex2;
    end->incident = incidentFace;
    end->isCut = true;
    return true;
}
} // namespace

void ClipToFace(b2Manifold* manifold, const ReferenceFace& face, const IncidentSide& side,
                float32 overhang, float32 radius)
{
    manifold->pointCount = 0;
    manifold->localNormal = face.normal;
    manifold->localPoint = 0.5f * (face.v1 + face.v2);

    // Outward is on the right of the face, so the direction along it is the normal rotated to the
    // left.
    const b2Vec2 along = face.normal.Skew();
    const float32 low = -overhang;
    const float32 high = b2Dot(face.v2 - face.v1, along) + overhang;
    const float32 xP = b2Dot(side.p - face.v1, along);
    const float32 xQ = b2Dot(side.q - face.v1, along);
    End ends[2] = {{0.0f, face.face, side.vertexP, false}, {1.0f, face.face, side.vertexQ, false}};
    if (!Cut(&ends[0], xP, xQ, low, high, face, side.face) ||
        !Cut(&ends[1], xQ, xP, low, high, face, side.face))
    {
        return;
    }

    const float32 heightP = b2Dot(side.p - face.v1, face.normal);
    const float32 heightQ = b2Dot(side.q - face.v1, face.normal);
    for (const End& end : ends)
    {
        // Weights of exactly 0 and 1 reproduce a vertex exactly.
        const float32 height = (1.0f - end.t) * heightP + end.t * heightQ;
        if (height <= radius)
        {
            b2ManifoldPoint& point = manifold->points[manifold->pointCount++];
            point.localPoint = (1.0f - end.t) * side.localP + end.t * side.localQ;
            point.normalImpulse = 0.0f;
            point.tangentImpulse = 0.0f;
            point.id = MakeId(end, manifold->type == b2Manifold::e_faceA);
        }
    }
}
} // namespace box2d
