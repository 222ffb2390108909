// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

#include <climits>

/// @file
/// Contact manifolds, ray casts, axis-aligned boxes and overlap: what two shapes can be asked.
/// The contact solver and programs that collide shapes without a world call these. No memory is
/// allocated and no shape is changed here.

class b2Shape;
class b2CircleShape;
class b2EdgeShape;
class b2PolygonShape;

/// No feature of a shape.
inline constexpr uint8 b2_nullFeature = UCHAR_MAX;

/// Which features of two shapes make a contact point. It stays the same while the same features
/// touch, so that a point keeps its impulses from step to step.
struct b2ContactFeature
{
    /// What a number counts.
    enum Type
    {
        e_vertex = 0,
        e_face = 1
    };

    uint8 indexA = 0; ///< vertex or face of shape A
    uint8 indexB = 0; ///< vertex or face of shape B
    uint8 typeA = 0;  ///< what indexA counts
    uint8 typeB = 0;  ///< what indexB counts
};

/// The feature pair, also as one number for quick comparison.
union b2ContactID {
    constexpr b2ContactID() : key(0) {}

    b2ContactFeature cf; ///< the pair
    uint32 key;          ///< the same bits as a number
};

/// One point of a manifold. What localPoint means depends on the manifold's type.
struct b2ManifoldPoint
{
    b2Vec2 localPoint;             ///< see b2Manifold::Type [m]
    float32 normalImpulse = 0.0f;  ///< that keeps the shapes apart, kept for warm starting [N s]
    float32 tangentImpulse = 0.0f; ///< of friction [N s]
    b2ContactID id;                ///< which features it comes from
};

/// How two convex shapes touch: a normal and up to two points, in local coordinates so that the
/// position solver can follow the bodies while it moves them. Points are kept as long as the
/// shapes' skins overlap.
struct b2Manifold
{
    /// How the members are to be read.
    enum Type
    {
        e_circles, ///< localPoint: centre of A; points[0].localPoint: centre of B; no localNormal
        e_faceA,   ///< localNormal, localPoint: a face of A, in A's frame; points in B's frame
        e_faceB    ///< localNormal, localPoint: a face of B, in B's frame; points in A's frame
    };

    b2ManifoldPoint points[b2_maxManifoldPoints]; ///< how many count says pointCount
    b2Vec2 localNormal;                           ///< unit vector; see Type
    b2Vec2 localPoint;                            ///< see Type [m]
    Type type = e_circles;                        ///< what the members mean
    int32 pointCount = 0;                         ///< 0 to b2_maxManifoldPoints
};

/// A manifold in world coordinates, for those who look at it.
struct b2WorldManifold
{
    /// From a manifold, where the shapes are, and their radii [m], >= 0. The shapes may have moved
    /// a little since the manifold was computed. Does nothing for a manifold without points.
    void Initialize(const b2Manifold* manifold, const b2Transform& xfA, float32 radiusA,
                    const b2Transform& xfB, float32 radiusB);

    b2Vec2 normal;                                            ///< unit vector from A to B
    b2Vec2 points[b2_maxManifoldPoints];                      ///< midway between the surfaces [m]
    float32 separations[b2_maxManifoldPoints] = {0.0f, 0.0f}; ///< negative is overlap [m]
};

/// What became of a contact point from one step to the next.
enum b2PointState
{
    b2_nullState,    ///< there is no such point
    b2_addState,     ///< the point is in the second manifold only
    b2_persistState, ///< the point is in both
    b2_removeState   ///< the point is in the first manifold only
};

/// What became of the points from one manifold to the next: state1 speaks of manifold1's points,
/// state2 of manifold2's.
void b2GetPointStates(b2PointState state1[b2_maxManifoldPoints],
                      b2PointState state2[b2_maxManifoldPoints], const b2Manifold* manifold1,
                      const b2Manifold* manifold2);

/// An end of a segment that is being clipped, and where it came from.
struct b2ClipVertex
{
    b2Vec2 v;       ///< where it is [m]
    b2ContactID id; ///< which features it comes from
};

/// A ray is the segment from p1 to p1 + maxFraction * (p2 - p1).
struct b2RayCastInput
{
    b2Vec2 p1;                  ///< where the ray starts [m]
    b2Vec2 p2;                  ///< where it ends at a fraction of 1 [m]
    float32 maxFraction = 1.0f; ///< how far it goes, in ways from p1 to p2; >= 0
};

/// The ray hits at p1 + fraction * (p2 - p1).
struct b2RayCastOutput
{
    b2Vec2 normal;           ///< of the surface that was hit, against the ray
    float32 fraction = 0.0f; ///< 0 to b2RayCastInput::maxFraction
};

/// An axis-aligned box. Nothing is checked but by IsValid.
struct b2AABB
{
    /// Are the bounds sorted and finite?
    bool IsValid() const
    {
        return lowerBound.x <= upperBound.x && lowerBound.y <= upperBound.y &&
               lowerBound.IsValid() && upperBound.IsValid();
    }

    /// The middle [m].
    constexpr b2Vec2 GetCenter() const { return 0.5f * (lowerBound + upperBound); }
    /// Half the width and half the height [m].
    constexpr b2Vec2 GetExtents() const { return 0.5f * (upperBound - lowerBound); }
    /// The length of its outline [m].
    constexpr float32 GetPerimeter() const
    {
        return 2.0f * ((upperBound.x - lowerBound.x) + (upperBound.y - lowerBound.y));
    }

    /// Grows to hold the other box too.
    constexpr void Combine(const b2AABB& aabb) { Combine(*this, aabb); }
    /// Becomes the smallest box that holds both.
    constexpr void Combine(const b2AABB& aabb1, const b2AABB& aabb2)
    {
        lowerBound = b2Min(aabb1.lowerBound, aabb2.lowerBound);
        upperBound = b2Max(aabb1.upperBound, aabb2.upperBound);
    }

    /// Is the other box inside this one, or equal to it?
    constexpr bool Contains(const b2AABB& aabb) const
    {
        return lowerBound.x <= aabb.lowerBound.x && lowerBound.y <= aabb.lowerBound.y &&
               aabb.upperBound.x <= upperBound.x && aabb.upperBound.y <= upperBound.y;
    }

    /// Where a ray meets the box. False, and `output` is as it was: nowhere. A ray that starts
    /// inside does not hit.
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input) const;

    b2Vec2 lowerBound; ///< the lower left corner [m]
    b2Vec2 upperBound; ///< the upper right corner [m]; no coordinate is below lowerBound's
};

/// Where two shapes touch, one function for each pair of kinds that can; no points: they do not.
/// Impulses are left at zero. No pointer is null, transforms are finite.
void b2CollideCircles(b2Manifold* manifold, const b2CircleShape* circleA, const b2Transform& xfA,
                      const b2CircleShape* circleB, const b2Transform& xfB);
/// As b2CollideCircles; the normal points from the polygon to the circle.
void b2CollidePolygonAndCircle(b2Manifold* manifold, const b2PolygonShape* polygonA,
                               const b2Transform& xfA, const b2CircleShape* circleB,
                               const b2Transform& xfB);
/// As b2CollideCircles, with up to two points.
void b2CollidePolygons(b2Manifold* manifold, const b2PolygonShape* polygonA, const b2Transform& xfA,
                       const b2PolygonShape* polygonB, const b2Transform& xfB);
/// As b2CollideCircles; knows the edge's ghost vertices.
void b2CollideEdgeAndCircle(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                            const b2CircleShape* circleB, const b2Transform& xfB);
/// As b2CollideCircles, with up to two points; knows the edge's ghost vertices.
void b2CollideEdgeAndPolygon(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                             const b2PolygonShape* polygonB, const b2Transform& xfB);

/// Keeps the part of a segment where b2Dot(normal, p) <= offset [m], the normal of unit length, and
/// returns how many of its ends are left in vOut: 2 or, when all is beyond, 0 (1 when one end lies
/// exactly on the line). An end made by clipping gets the id (vertexIndexA of A, face of B).
int32 b2ClipSegmentToLine(b2ClipVertex vOut[2], const b2ClipVertex vIn[2], const b2Vec2& normal,
                          float32 offset, int32 vertexIndexA);

/// Do the shapes, or these children of them (0 <= index < GetChildCount()), overlap? Radii count.
bool b2TestOverlap(const b2Shape* shapeA, int32 indexA, const b2Shape* shapeB, int32 indexB,
                   const b2Transform& xfA, const b2Transform& xfB);

/// Boxes that only touch overlap too.
constexpr bool b2TestOverlap(const b2AABB& a, const b2AABB& b)
{
    // All four are compared: which of them fails is hard to foresee, and a branch would cost more.
    return (a.lowerBound.x <= b.upperBound.x) & (b.lowerBound.x <= a.upperBound.x) &
           (a.lowerBound.y <= b.upperBound.y) & (b.lowerBound.y <= a.upperBound.y);
}
