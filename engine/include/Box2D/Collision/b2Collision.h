// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

#include <climits>

/// @file
/// Contact manifolds, ray casts, axis-aligned boxes and overlap tests. The contact solver calls
/// these, and so may programs that collide shapes without a world. These functions allocate no
/// memory and change no shape.

class b2Shape;
class b2CircleShape;
class b2EdgeShape;
class b2PolygonShape;

/// Value that marks the absence of a feature.
inline constexpr uint8 b2_nullFeature = UCHAR_MAX;

/// The features of two shapes that create a contact point. The value is stable while the same
/// features touch, so that a point keeps its impulses from step to step.
struct b2ContactFeature
{
    /// The kind of feature an index refers to.
    enum Type
    {
        e_vertex = 0,
        e_face = 1
    };

    uint8 indexA = 0; ///< index of a vertex or face of shape A
    uint8 indexB = 0; ///< index of a vertex or face of shape B
    uint8 typeA = 0;  ///< type of indexA
    uint8 typeB = 0;  ///< type of indexB
};

/// A feature pair, also readable as one integer for fast comparison.
union b2ContactID {
    constexpr b2ContactID() : key(0) {}

    b2ContactFeature cf; ///< the pair
    uint32 key;          ///< the same bits as an integer
};

/// One point of a manifold. The meaning of localPoint depends on the manifold's type.
struct b2ManifoldPoint
{
    b2Vec2 localPoint;             ///< see b2Manifold::Type [m]
    float32 normalImpulse = 0.0f;  ///< non-penetration impulse, kept for warm starting [N s]
    float32 tangentImpulse = 0.0f; ///< friction impulse [N s]
    b2ContactID id;                ///< features that created it
};

/// The contact of two convex shapes: a normal and up to two points. Local coordinates allow the
/// position solver to move the bodies without a new manifold. Points are kept while the skins of
/// the shapes overlap.
struct b2Manifold
{
    /// Defines the meaning of the members.
    enum Type
    {
        e_circles, ///< localPoint: centre of A; points[0].localPoint: centre of B; no localNormal
        e_faceA,   ///< localNormal, localPoint: a face of A, in A's frame; points in B's frame
        e_faceB    ///< localNormal, localPoint: a face of B, in B's frame; points in A's frame
    };

    b2ManifoldPoint points[b2_maxManifoldPoints]; ///< the first pointCount are valid
    b2Vec2 localNormal;                           ///< unit vector; see Type
    b2Vec2 localPoint;                            ///< see Type [m]
    Type type = e_circles;                        ///< interpretation of the members
    int32 pointCount = 0;                         ///< 0 to b2_maxManifoldPoints
};

/// A manifold in world coordinates.
struct b2WorldManifold
{
    /// Computes the world manifold from a manifold, the transforms and the radii [m], >= 0. The
    /// shapes may have moved a little since the manifold was computed. Does nothing for a manifold
    /// without points.
    void Initialize(const b2Manifold* manifold, const b2Transform& xfA, float32 radiusA,
                    const b2Transform& xfB, float32 radiusB);

    b2Vec2 normal;                                            ///< unit vector from A to B
    b2Vec2 points[b2_maxManifoldPoints];                      ///< midway between the surfaces [m]
    float32 separations[b2_maxManifoldPoints] = {0.0f, 0.0f}; ///< negative: overlap [m]
};

/// The change of a contact point between two steps.
enum b2PointState
{
    b2_nullState,    ///< the point does not exist
    b2_addState,     ///< the point is in the second manifold only
    b2_persistState, ///< the point is in both
    b2_removeState   ///< the point is in the first manifold only
};

/// Compares two manifolds: state1 describes the points of manifold1, state2 those of manifold2.
void b2GetPointStates(b2PointState state1[b2_maxManifoldPoints],
                      b2PointState state2[b2_maxManifoldPoints], const b2Manifold* manifold1,
                      const b2Manifold* manifold2);

/// A vertex of a clipped segment, with the features that created it.
struct b2ClipVertex
{
    b2Vec2 v;       ///< position [m]
    b2ContactID id; ///< features that created it
};

/// A ray is the segment from p1 to p1 + maxFraction * (p2 - p1).
struct b2RayCastInput
{
    b2Vec2 p1;                  ///< start [m]
    b2Vec2 p2;                  ///< end at fraction 1 [m]
    float32 maxFraction = 1.0f; ///< length as a multiple of p2 - p1, >= 0
};

/// The ray hits at p1 + fraction * (p2 - p1).
struct b2RayCastOutput
{
    b2Vec2 normal;           ///< unit normal of the surface, against the ray
    float32 fraction = 0.0f; ///< 0 to b2RayCastInput::maxFraction
};

/// An axis-aligned box. Only IsValid checks the bounds.
struct b2AABB
{
    /// True if the bounds are sorted and finite.
    bool IsValid() const
    {
        return lowerBound.x <= upperBound.x && lowerBound.y <= upperBound.y &&
               lowerBound.IsValid() && upperBound.IsValid();
    }

    /// Returns the centre [m].
    constexpr b2Vec2 GetCenter() const { return 0.5f * (lowerBound + upperBound); }
    /// Returns half the width and half the height [m].
    constexpr b2Vec2 GetExtents() const { return 0.5f * (upperBound - lowerBound); }
    /// Returns the perimeter [m].
    constexpr float32 GetPerimeter() const
    {
        return 2.0f * ((upperBound.x - lowerBound.x) + (upperBound.y - lowerBound.y));
    }

    /// Grows to contain the other box.
    constexpr void Combine(const b2AABB& aabb) { Combine(*this, aabb); }
    /// Becomes the smallest box that contains both.
    constexpr void Combine(const b2AABB& aabb1, const b2AABB& aabb2)
    {
        lowerBound = b2Min(aabb1.lowerBound, aabb2.lowerBound);
        upperBound = b2Max(aabb1.upperBound, aabb2.upperBound);
    }

    /// True if the other box is inside this one or equal to it.
    constexpr bool Contains(const b2AABB& aabb) const
    {
        return lowerBound.x <= aabb.lowerBound.x && lowerBound.y <= aabb.lowerBound.y &&
               aabb.upperBound.x <= upperBound.x && aabb.upperBound.y <= upperBound.y;
    }

    /// Finds the hit of a ray with the box. Returns false and leaves `output` unchanged if there is
    /// none. A ray that starts inside does not hit.
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input) const;

    b2Vec2 lowerBound; ///< lower left corner [m]
    b2Vec2 upperBound; ///< upper right corner [m], >= lowerBound in each coordinate
};

/// Computes the manifold of two shapes; without a contact it has no points. Impulses are 0. There
/// is one function per pair of shape types. Pointers are not null, transforms are finite.
void b2CollideCircles(b2Manifold* manifold, const b2CircleShape* circleA, const b2Transform& xfA,
                      const b2CircleShape* circleB, const b2Transform& xfB);
/// Same as b2CollideCircles; the normal points from the polygon to the circle.
void b2CollidePolygonAndCircle(b2Manifold* manifold, const b2PolygonShape* polygonA,
                               const b2Transform& xfA, const b2CircleShape* circleB,
                               const b2Transform& xfB);
/// Same as b2CollideCircles, with up to two points.
void b2CollidePolygons(b2Manifold* manifold, const b2PolygonShape* polygonA, const b2Transform& xfA,
                       const b2PolygonShape* polygonB, const b2Transform& xfB);
/// Same as b2CollideCircles; uses the edge's ghost vertices.
void b2CollideEdgeAndCircle(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                            const b2CircleShape* circleB, const b2Transform& xfB);
/// Same as b2CollideCircles, with up to two points; uses the edge's ghost vertices.
void b2CollideEdgeAndPolygon(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                             const b2PolygonShape* polygonB, const b2Transform& xfB);

/// Clips a segment to b2Dot(normal, p) <= offset [m], with a unit normal, and returns the number of
/// vertices in vOut. This is 2, or 0 if the segment is outside, or 1 if one end is exactly on the
/// line. A vertex made by clipping gets the id (vertexIndexA of A, face of B).
int32 b2ClipSegmentToLine(b2ClipVertex vOut[2], const b2ClipVertex vIn[2], const b2Vec2& normal,
                          float32 offset, int32 vertexIndexA);

/// True if the shapes, or these children (0 <= index < GetChildCount()), overlap. Radii are
/// included.
bool b2TestOverlap(const b2Shape* shapeA, int32 indexA, const b2Shape* shapeB, int32 indexB,
                   const b2Transform& xfA, const b2Transform& xfB);

/// True if the boxes overlap or touch.
constexpr bool b2TestOverlap(const b2AABB& a, const b2AABB& b)
{
    // Evaluates all four without branches: which one fails is unpredictable, and a mispredicted
    // branch costs more.
    return (a.lowerBound.x <= b.upperBound.x) & (b.lowerBound.x <= a.upperBound.x) &
           (a.lowerBound.y <= b.upperBound.y) & (b.lowerBound.y <= a.upperBound.y);
}
