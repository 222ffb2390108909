// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

#include "../../Collision/ImpactTarget.h"

#include <Box2D/Collision/Shapes/b2ChainShape.h>
#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

#include <cmath>

/// The paths of bodies during a step, and cheap tests on them: the pose at a time, the length, and
/// whether two bodies could touch. Continuous collision uses them before computing a time of
/// impact. Bodies are not changed.
namespace box2d
{

/// Relative margin for rounding, of sums of distances: some 80 roundings of a float. Only a contact
/// that is nearly in reach is tested without need for it. With 0 and 1e-3 all tests pass, also
/// those that compare bits.
inline constexpr float32 kDistanceRounding = 1e-5f;

inline Pose Between(const Pose& from, const Pose& to, double share)
{
    return Pose{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
                from.angle + share * (to.angle - from.angle)};
}

/// Returns the body's pose at a fraction of the step within its path.
inline Pose PoseAt(const BodyData& body, float32 time)
{
    if (time == body.sweepStart)
    {
        return body.previous;
    }
    const double share = (double(time) - double(body.sweepStart)) / (1.0 - double(body.sweepStart));
    return Between(body.previous, body.pose, share);
}

/// Returns the rest of the path as a sweep from 0 to 1, relative to `origin`, with angles near
/// zero.
inline b2Sweep SweepFrom(const BodyData& body, const Pose& start, const Pose& origin)
{
    constexpr double turn = 2.0 * 3.14159265358979323846;
    const double wholeTurns = turn * std::floor(start.angle / turn);
    b2Sweep sweep;
    sweep.localCenter = body.localCenter;
    sweep.c0 = b2Vec2(float32(start.x - origin.x), float32(start.y - origin.y));
    sweep.c = b2Vec2(float32(body.pose.x - origin.x), float32(body.pose.y - origin.y));
    sweep.a0 = float32(start.angle - wholeTurns);
    sweep.a = float32(body.pose.angle - wholeTurns);
    sweep.alpha0 = 0.0f;
    return sweep;
}

/// Returns the box around a circle that moves straight.
inline b2AABB BoxOfPath(const b2Vec2& from, const b2Vec2& to, float32 radius)
{
    const b2Vec2 reach(radius, radius);
    b2AABB box;
    box.lowerBound = b2Min(from, to) - reach;
    box.upperBound = b2Max(from, to) + reach;
    return box;
}

/// True if a rotation [rad] moves a shape far out of the boxes of its start and its end. That is
/// more than a quarter turn, which only sub-steps allow.
inline bool IsWide(double turn)
{
    // A step without sub-steps rotates by b2_maxRotation at most, up to rounding. Rounding is a few
    // millionths, far less than the 1 %.
    constexpr double kRounding = 1.01;
    return std::abs(turn) > kRounding * double(b2_maxRotation);
}

/// Returns the box around a shape at the start and end of a sweep. For a wide rotation it is the
/// box of the body's circle, with radius `maxExtent` [m].
inline b2AABB SweptBox(const b2Shape& shape, int32 child, const b2Sweep& sweep, float32 maxExtent)
{
    if (IsWide(double(sweep.a - sweep.a0)))
    {
        return BoxOfPath(sweep.c0, sweep.c, maxExtent);
    }
    if (shape.GetType() == b2Shape::e_circle && sweep.localCenter == b2Vec2_zero &&
        static_cast<const b2CircleShape&>(shape).m_p == b2Vec2_zero)
    {
        // A circle about the centre of mass is invariant under rotation.
        return BoxOfPath(sweep.c0, sweep.c, shape.m_radius);
    }
    b2Transform from;
    b2Transform to;
    sweep.GetTransform(&from, 0.0f);
    sweep.GetTransform(&to, 1.0f);
    b2AABB box;
    b2AABB end;
    shape.ComputeAABB(&box, from, child);
    shape.ComputeAABB(&end, to, child);
    box.Combine(end);
    return box;
}

inline float32 PathLength(const BodyData& body)
{
    const float32 dx = float32(body.pose.x - body.previous.x);
    const float32 dy = float32(body.pose.y - body.previous.y);
    return b2Vec2(dx, dy).Length() +
           b2Abs(float32(body.pose.angle - body.previous.angle)) * body.maxExtent;
}

/// True if the body can be stopped at that time. A sleeping platform does not move, and no impact
/// wakes it: the rest of its path must start at 0 in the next step too.
inline bool CanAdvance(const BodyData& body, float32 time)
{
    const bool moves = body.mobility == Mobility::Dynamic ||
                       (body.mobility == Mobility::Kinematic && body.IsAwake());
    return moves && body.sweepStart <= time;
}

inline bool IsFast(const BodyData& body)
{
    return body.IsDynamic() && PathLength(body) > kFastShare * body.minExtent;
}

/// Returns the maximum distance of two centres at which the bodies can touch: the radii of their
/// circles, a slop, and a margin for rounding.
inline float32 Reach(const BodyData& a, const BodyData& b)
{
    return (1.0f + kDistanceRounding) * (a.maxExtent + b.maxExtent) + b2_linearSlop;
}

inline bool IsWithin(const b2Vec2& offset, float32 reach)
{
    return !(offset.LengthSquared() > reach * reach); // NaN counts as near
}

/// True if the circles of two bodies meet on their straight paths, from the given poses to the
/// current ones; otherwise the bodies cannot touch.
inline bool CirclesMeet(const BodyData& a, const Pose& fromA, const BodyData& b, const Pose& fromB)
{
    const b2Vec2 start(float32(fromB.x - fromA.x), float32(fromB.y - fromA.y));
    const b2Vec2 end(float32(b.pose.x - a.pose.x), float32(b.pose.y - a.pose.y));
    const b2Vec2 path = end - start;
    const float32 along = -b2Dot(start, path);
    const float32 square = path.LengthSquared();
    // Fraction of the path, 0 to 1, at which the centres are closest.
    const float32 share = along <= 0.0f || square == 0.0f ? 0.0f : b2Min(along / square, 1.0f);
    const b2Vec2 nearest = start + share * path;
    return IsWithin(nearest, Reach(a, b));
}

/// A circle about the centre of mass: it goes straight on, and its turn changes nothing.
inline bool IsRoundAbout(const BodyData& body, const b2Shape& shape)
{
    return shape.GetType() == b2Shape::e_circle &&
           static_cast<const b2CircleShape&>(shape).m_p == body.localCenter;
}

/// Returns the time of impact of two such circles in closed form. It is a fraction of their paths
/// from the given poses to the current ones. It uses the target and tolerance of b2TimeOfImpact; 1
/// if there is no impact.
inline float32 CircleImpact(const BodyData& a, const Pose& fromA, const BodyData& b,
                            const Pose& fromB, float32 radii)
{
    // With d0 from centre to centre at the start and w the displacement of B relative to A
    //   |d0 + t w| = D,  t = (d0^2 - D^2) / (-d0.w + sqrt((d0.w)^2 - w^2 (d0^2 - D^2)))
    const double d0x = fromB.x - fromA.x;
    const double d0y = fromB.y - fromA.y;
    const double wx = (b.pose.x - a.pose.x) - d0x;
    const double wy = (b.pose.y - a.pose.y) - d0y;
    const double D = double(ImpactDistance(radii)) + double(kImpactTolerance);
    const double square = d0x * d0x + d0y * d0y;
    const double outside = square - D * D;
    if (outside < 0.0)
    {
        return square > 0.0 ? 0.0f : 1.0f; // coincident centres have no separating direction
    }
    const double along = d0x * wx + d0y * wy;
    const double root = along * along - (wx * wx + wy * wy) * outside;
    if (along >= 0.0 || root < 0.0)
    {
        return 1.0f;
    }
    return float32(b2Min(outside / (std::sqrt(root) - along), 1.0));
}

/// Returns the distance of a point from the line of an edge, or beyond one of its ends along it.
inline float32 InFrontOfEdge(const b2Vec2& v1, const b2Vec2& v2, const b2Vec2& point)
{
    b2Vec2 along = v2 - v1;
    const float32 length = along.Normalize();
    const b2Vec2 offset = point - v1;
    const float32 place = b2Dot(along, offset);
    return b2Max(b2Abs(b2Cross(along, offset)), b2Max(-place, place - length));
}

/// Returns the distance of a point in front of a face, in the shape's frame. It is the maximum over
/// all faces, at most the distance from the core. Circles have no faces.
inline float32 InFront(const b2Shape& shape, int32 child, const b2Vec2& point)
{
    float32 maximum = -b2_maxFloat;
    if (shape.GetType() == b2Shape::e_polygon)
    {
        const auto& polygon = static_cast<const b2PolygonShape&>(shape);
        for (int32 i = 0; i < polygon.m_count; ++i)
        {
            maximum = b2Max(maximum, b2Dot(polygon.m_normals[i], point - polygon.m_vertices[i]));
        }
    }
    else if (shape.GetType() == b2Shape::e_edge)
    {
        const auto& edge = static_cast<const b2EdgeShape&>(shape);
        maximum = InFrontOfEdge(edge.m_vertex1, edge.m_vertex2, point);
    }
    else if (shape.GetType() == b2Shape::e_chain)
    {
        const b2Vec2* vertices = static_cast<const b2ChainShape&>(shape).m_vertices + child;
        maximum = InFrontOfEdge(vertices[0], vertices[1], point);
    }
    return maximum;
}

/// True if the other body's circle stays in front of one face of the shape for its whole path, out
/// of reach of an impact. Typical for many small bodies near a large one. The test uses the end
/// pose and a bound of the other centre's displacement. Relative to the body this is its path plus
/// the arc of the body's rotation.
inline bool StaysInFront(const BodyData& body, const Pose& from, const b2Shape& shape, int32 child,
                         const BodyData& other, const Pose& otherFrom)
{
    const b2Vec2 start(float32(otherFrom.x - from.x), float32(otherFrom.y - from.y));
    const b2Vec2 end(float32(other.pose.x - body.pose.x), float32(other.pose.y - body.pose.y));
    const float32 away = b2Max(start.Length(), end.Length());
    const float32 path =
        (end - start).Length() + b2Abs(float32(body.pose.angle - from.angle)) * away;
    const b2Vec2 center = b2MulT(body.rotation, end) + body.localCenter;
    const float32 reach = path + other.maxExtent + shape.m_radius + 2.0f * b2_linearSlop +
                          kDistanceRounding * (away + path + body.maxExtent + other.maxExtent);
    return InFront(shape, child, center) > reach;
}

/// Returns true if two children without a contact could touch during the step or at its end. False
/// is only allowed for a bullet that is queried again in the next step, against a static body or
/// another such bullet. Otherwise no query would follow when the other body moves.
inline bool PathsMeet(const BodyData& a, const b2Shape& shapeA, int32 childA, const BodyData& b,
                      const b2Shape& shapeB, int32 childB)
{
    const bool sweptA = (a.flags & kBodyPathBox) != 0;
    const bool sweptB = (b.flags & kBodyPathBox) != 0;
    if (!(sweptA && (sweptB || b.mobility == Mobility::Static)) &&
        !(sweptB && a.mobility == Mobility::Static))
    {
        return true;
    }
    const float32 start = b2Max(a.sweepStart, b.sweepStart);
    const Pose fromA = PoseAt(a, start);
    const Pose fromB = PoseAt(b, start);
    return CirclesMeet(a, fromA, b, fromB) &&
           !(a.maxExtent > b.maxExtent ? StaysInFront(a, fromA, shapeA, childA, b, fromB)
                                       : StaysInFront(b, fromB, shapeB, childB, a, fromA));
}

} // namespace box2d
