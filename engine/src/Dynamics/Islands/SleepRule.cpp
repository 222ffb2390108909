// SPDX-License-Identifier: MIT
#include "SleepRule.h"

namespace box2d
{

namespace
{

/// A body that is pushed out of skins rests up to this multiple of the sleep tolerances, 10 cm/s.
/// The skins of a pyramid are pushed out by 3 cm/s after 4 s (docs/notes/pyramid-load.md). With 3,
/// new pyramids take more than a second to sleep. With 30 no test fails.
constexpr float32 kSkinsPace = 10.0f;
/// For so long a body must not have gained speed before it rests [s]: three steps of 1/60 s,
/// because rounding may slow down a single one. With 0.01 rods on their end sleep while they fall,
/// with 0.16 bridges stay awake (docs/notes/tuned-constants.md).
constexpr float32 kCalm = 0.04f;

// True for a pendulum at its turning point or a body thrown up in weak gravity: slow, but with
// changing velocity. Bodies with contacts are not tested, because stacks tremble.
bool IsTurning(const BodyData& body, const SolverBody& moved, float32 timeStep)
{
    constexpr float32 kMaxGain = 0.25f / b2_timeToSleep; // fraction of the tolerance, per second
    const float32 linear = timeStep * kMaxGain * b2_linearSleepTolerance;
    const float32 angular = timeStep * kMaxGain * b2_angularSleepTolerance;
    return body.colorMask == 0 &&
           ((moved.v - body.linearVelocity).LengthSquared() > linear * linear ||
            b2Abs(moved.w - body.angularVelocity) > angular);
}

// True for a body that leaves an unstable balance, such as a rod on its end: slow for long, but
// accelerating. Without sub-steps joints tremble more than that, and stacks always do.
bool IsSettingOff(const BodyData& body, const SolverBody& moved, float32 timeStep)
{
    constexpr float32 kMinGain = 1.0f / 15.0f; // fraction of the tolerance, per second
    const float32 linear = timeStep * kMinGain * b2_linearSleepTolerance;
    const float32 angular = timeStep * kMinGain * b2_angularSleepTolerance;
    return body.colorMask == 0 && (moved.v.Length() > body.linearVelocity.Length() + linear ||
                                   b2Abs(moved.w) > b2Abs(body.angularVelocity) + angular);
}

/// True if the step displaced the body by no more than `pace` times the sleep tolerances.
bool HasHardlyMoved(const SolverBody& moved, float32 pace)
{
    const float32 linear = pace * b2_linearSleepTolerance;
    const float32 angular = pace * b2_angularSleepTolerance;
    return moved.d.LengthSquared() <= linear * linear && b2Abs(moved.angle) <= angular;
}

} // namespace

bool IsSlow(const b2Vec2& linearVelocity, float32 angularVelocity)
{
    return linearVelocity.LengthSquared() <= b2_linearSleepTolerance * b2_linearSleepTolerance &&
           b2Abs(angularVelocity) <= b2_angularSleepTolerance;
}

// Slow: velocity and position correction are below the tolerances. A body that is still pushed out
// of an overlap does not sleep, unless only the skins overlap. A platform is moved by the user, so
// it stays awake at any speed but zero.
float32 SleepTimeAfter(const BodyData& body, const SolverBody& moved, const SleepStep& step)
{
    const float32 h = step.timeStep;
    if (!body.IsDynamic())
    {
        const bool still = moved.v == b2Vec2(0.0f, 0.0f) && moved.w == 0.0f;
        return still && (body.flags & kBodyAutoSleep) != 0 ? body.sleepTime + h : 0.0f;
    }
    const float32 pace = step.isPushedOut ? h : kSkinsPace * h;
    if (!IsSlow(moved.v, moved.w) || !HasHardlyMoved(moved, pace) ||
        (body.flags & kBodyAutoSleep) == 0)
    {
        return 0.0f;
    }
    const float32 time = body.sleepTime + h;
    if (step.inSubSteps && body.sleepTime < b2_timeToSleep && IsSettingOff(body, moved, h))
    {
        return b2Min(time, b2_timeToSleep - kCalm);
    }
    return time >= b2_timeToSleep && IsTurning(body, moved, h) ? body.sleepTime : time;
}

float32 MaxRestOverlap(float32 radius)
{
    // The skins of two polygons and a slop [m]. Such an overlap is not visible.
    constexpr float32 kUnseenOverlap = 2.0f * b2_polygonRadius + b2_linearSlop;
    // `radius` is a sum of radii, so that of two polygons may be rounded.
    constexpr float32 kRounding = 1.01f;
    const bool skins = radius <= kRounding * 2.0f * b2_polygonRadius;
    return skins ? kUnseenOverlap : kMinRestOverlap;
}

} // namespace box2d
