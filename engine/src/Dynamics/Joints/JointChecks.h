// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Reach.h"

#include <Box2D/Common/b2Math.h>

class b2Body;

/// Checks of a joint's numbers, for definitions and setters. Each prints its sentence and aborts
/// with asserts on, or is false with asserts off.
namespace box2d
{

inline bool AreBodies(const b2Body* a, const b2Body* b)
{
    return B2_REQUIRE(a != nullptr && b != nullptr, "A joint's definition needs two bodies.");
}

inline bool AreAnchors(const b2Vec2& a, const b2Vec2& b)
{
    return B2_REQUIRE(IsWithinReach(a) && IsWithinReach(b),
                      "A joint's anchors must be finite and within 1e15 m.");
}

inline bool IsTarget(const b2Vec2& point)
{
    return B2_REQUIRE(IsWithinReach(point),
                      "A joint's target or offset must be finite and within 1e15 m.");
}

inline bool IsAxis(const b2Vec2& axis)
{
    return B2_REQUIRE(axis.IsValid() && axis.LengthSquared() > 0.0f,
                      "A joint's axis must be finite and not zero.");
}

inline bool IsAngle(float32 angle)
{
    return B2_REQUIRE(b2IsValid(angle), "A joint's angles must be finite.");
}

inline bool IsLength(float32 length)
{
    return B2_REQUIRE(IsWithinReach(length) && length >= 0.0f,
                      "A joint's length must be finite, within 1e15 m and not negative.");
}

/// Lengths below the slop and limits in the wrong order are clamped, so they are sound. The joint
/// stores an infinite maximum as b2_maxFloat.
inline bool AreLengthLimits(float32 minLength, float32 maxLength)
{
    return B2_REQUIRE(
        IsWithinReach(minLength) && (maxLength >= b2_maxFloat || IsWithinReach(maxLength)),
        "A distance joint's limits must be within 1e15 m; the maximum may be infinite.");
}

inline bool IsSpring(float32 frequencyHz, float32 dampingRatio)
{
    return B2_REQUIRE(b2IsValid(frequencyHz) && frequencyHz >= 0.0f && b2IsValid(dampingRatio) &&
                          dampingRatio >= 0.0f,
                      "A joint's frequency and damping ratio must be finite and not negative.");
}

inline bool AreLimits(bool enabled, float32 lower, float32 upper)
{
    return B2_REQUIRE(b2IsValid(lower) && b2IsValid(upper) && (!enabled || lower <= upper),
                      "A joint's limits must be finite, the lower limit not above the upper one.");
}

/// The maximum force may be infinite, for a motor that cannot be stopped.
inline bool IsMotor(float32 speed, float32 largest)
{
    return B2_REQUIRE(b2IsValid(speed) && largest >= 0.0f,
                      "A joint's motor needs a finite speed and a maximum force or torque that is "
                      "not negative.");
}

inline bool AreForces(float32 force, float32 torque)
{
    return B2_REQUIRE(force >= 0.0f && torque >= 0.0f,
                      "A joint's maximum force and torque must not be negative.");
}

inline bool IsShare(float32 factor)
{
    return B2_REQUIRE(factor >= 0.0f && factor <= 1.0f,
                      "A motor joint's correction factor must be between 0 and 1.");
}

inline bool IsGearRatio(float32 ratio)
{
    return B2_REQUIRE(b2IsValid(ratio), "A gear joint's ratio must be finite.");
}

} // namespace box2d
