// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>

/// The last step of every manifold with two points: clips a side of one shape to the width of a
/// face of the other. Used for polygons and edges. "Reference" is the shape with the face,
/// "incident" the other.
namespace box2d
{
struct ReferenceFace
{
    b2Vec2 v1;     ///< start, in the reference shape's frame
    b2Vec2 v2;     ///< end; the outside is on the right of the direction from v1 to v2
    b2Vec2 normal; ///< outward unit normal
    uint8 face;    ///< index of the face, and those of its ends
    uint8 vertex1;
    uint8 vertex2;
};

struct IncidentSide
{
    b2Vec2 p;      ///< start, in the reference shape's frame
    b2Vec2 q;      ///< end
    b2Vec2 localP; ///< the same, in the incident shape's frame
    b2Vec2 localQ;
    uint8 face; ///< index of the side, and those of its ends
    uint8 vertexP;
    uint8 vertexQ;
};

/// Fills the manifold with the ends of the cut side that are no higher above the face than the
/// radius. The side may stick out of the face by `overhang` at either end. The type must be set: it
/// defines whether the reference shape is A or B.
void ClipToFace(b2Manifold* manifold, const ReferenceFace& face, const IncidentSide& side,
                float32 overhang, float32 radius);
} // namespace box2d
