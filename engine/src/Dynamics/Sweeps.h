// SPDX-License-Identifier: MIT
#pragma once

#include "Solver.h"

#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

#include <cmath>

/// The ways of bodies during a step, and cheap questions about them: where a body is at a time, how
/// far it goes, whether two could touch at all. Continuous collision asks them before it looks for
/// the time of an impact; none of this changes a body.
namespace box2d
{

inline Pose Between(const Pose& from, const Pose& to, double share)
{
    return Pose{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
                from.angle + share * (to.angle - from.angle)};
}

/// The body's pose at a fraction of the step that its way still covers.
inline Pose PoseAt(const BodyData& body, float32 time)
{
    if (body.sweepStart >= 1.0f || time >= 1.0f)
    {
        return body.pose;
    }
    if (time == body.sweepStart)
    {
        return body.previous;
    }
    const double share = (double(time) - double(body.sweepStart)) / (1.0 - double(body.sweepStart));
    return Between(body.previous, body.pose, share);
}

/// The rest of the way as a sweep from 0 to 1, seen from `origin`, with angles near zero.
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

/// The box around a shape at the start and at the end of a sweep.
inline b2AABB SweptBox(const b2Shape& shape, int32 child, const b2Sweep& sweep)
{
    if (shape.GetType() == b2Shape::e_circle && sweep.localCenter == b2Vec2_zero &&
        static_cast<const b2CircleShape&>(shape).m_p == b2Vec2_zero)
    {
        // A circle about the centre turns in place.
        const b2Vec2 reach(shape.m_radius, shape.m_radius);
        b2AABB box;
        box.lowerBound = b2Min(sweep.c0, sweep.c) - reach;
        box.upperBound = b2Max(sweep.c0, sweep.c) + reach;
        return box;
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

inline float32 Way(const BodyData& body)
{
    const float32 dx = float32(body.pose.x - body.previous.x);
    const float32 dy = float32(body.pose.y - body.previous.y);
    return b2Vec2(dx, dy).Length() +
           b2Abs(float32(body.pose.angle - body.previous.angle)) * body.maxExtent;
}

/// Whether the body can be stopped where it is at that time.
inline bool CanAdvance(const BodyData& body, float32 time)
{
    return body.mobility != Mobility::Static && body.sweepStart <= time;
}

inline bool IsFast(const BodyData& body)
{
    return body.IsDynamic() && Way(body) > kFastShare * body.minExtent;
}

/// How far apart two centres may be for the bodies to touch: a slop and a little more than the
/// circles around them, for what rounding adds.
inline float32 Reach(const BodyData& a, const BodyData& b)
{
    return 1.00001f * (a.maxExtent + b.maxExtent) + b2_linearSlop;
}

inline bool IsWithin(const b2Vec2& offset, float32 reach)
{
    return !(offset.LengthSquared() > reach * reach); // what is no number counts as near
}

/// Whether two bodies on their straight ways come as near to each other as their circles reach:
/// nothing of them can touch else. The ways go from the given poses to the present ones.
inline bool CirclesMeet(const BodyData& a, const Pose& fromA, const BodyData& b, const Pose& fromB)
{
    const b2Vec2 start(float32(fromB.x - fromA.x), float32(fromB.y - fromA.y));
    const b2Vec2 end(float32(b.pose.x - a.pose.x), float32(b.pose.y - a.pose.y));
    const b2Vec2 way = end - start;
    const float32 along = -b2Dot(start, way);
    const float32 square = way.LengthSquared();
    // Where on the way, from 0 to 1, the centres are nearest.
    const float32 share = along <= 0.0f || square == 0.0f ? 0.0f : b2Min(along / square, 1.0f);
    const b2Vec2 nearest = start + share * way;
    return IsWithin(nearest, Reach(a, b));
}

} // namespace box2d
