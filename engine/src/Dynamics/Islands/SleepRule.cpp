// SPDX-License-Identifier: MIT
#include "SleepRule.h"

namespace box2d
{

namespace
{

/// For so long a body must not have gained speed before it rests [s]. That takes three steps of
/// 1/60 s, because rounding may slow down a single one. With 0.01 rods on their end sleep while
/// they fall, with 0.16 bridges stay awake (docs/notes/tuned-constants.md).
constexpr float32 kCalm = 0.04f;

// True for a pendulum at its turning point or a body thrown up in weak gravity: slow, but with
// changing velocity. Bodies with contacts are not tested, because stacks tremble.
bool IsTurning(const BodyData& body, const SolverBody& moved, float32 timeStep)
{
    // Fraction of the tolerance, per second: a quarter in the time to sleep. With a tenth bridges
    // rest 3 s later, with ten times as much pendulums sleep at their turning points
    // (docs/notes/tuned-constants.md).
    constexpr float32 kMaxGain = 0.25f / b2_timeToSleep;
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
    // Fraction of the tolerance, per second: above the rounding of stored speeds, and below the
    // gain of a rod that falls. With ten times as much bridges rest 1 to 2 s earlier. No test fails
    // with that or with a tenth (docs/notes/tuned-constants.md).
    constexpr float32 kMinGain = 1.0f / 15.0f;
    const float32 linear = timeStep * kMinGain * b2_linearSleepTolerance;
    const float32 angular = timeStep * kMinGain * b2_angularSleepTolerance;
    return body.colorMask == 0 && (moved.v.Length() > body.linearVelocity.Length() + linear ||
                                   b2Abs(moved.w) > b2Abs(body.angularVelocity) + angular);
}

/// True if the step displaced the body by no more than the sleep tolerances would.
bool HasHardlyMoved(const SolverBody& moved, float32 timeStep)
{
    const float32 linear = timeStep * b2_linearSleepTolerance;
    const float32 angular = timeStep * b2_angularSleepTolerance;
    return moved.d.LengthSquared() <= linear * linear && b2Abs(moved.angle) <= angular;
}

} // namespace

bool IsSlow(const b2Vec2& linearVelocity, float32 angularVelocity)
{
    return linearVelocity.LengthSquared() <= b2_linearSleepTolerance * b2_linearSleepTolerance &&
           b2Abs(angularVelocity) <= b2_angularSleepTolerance;
}

// Slow: velocity and position correction are below the tolerances. A body that is still pushed out
// of an overlap does not sleep. A platform is moved by the user, so it stays awake at any speed but
// zero.
float32 SleepTimeAfter(const BodyData& body, const SolverBody& moved, const SleepStep& step)
{
    const float32 h = step.timeStep;
    if (!body.IsDynamic())
    {
        const bool still = moved.v == b2Vec2(0.0f, 0.0f) && moved.w == 0.0f;
        return still && (body.flags & kBodyAutoSleep) != 0 ? body.sleepTime + h : 0.0f;
    }
    if (!IsSlow(moved.v, moved.w) || !HasHardlyMoved(moved, h) ||
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

} // namespace box2d
