// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// The limits of coordinates. Input checks and bodies enforce them; the solver does not check.
namespace box2d
{

/// Maximum coordinate [m]: squares of distances stay within single precision.
inline constexpr float32 kReach = 1e15f;

/// False for NaN.
inline bool IsWithinReach(float32 a)
{
    return b2Abs(a) <= kReach;
}

inline bool IsWithinReach(const b2Vec2& a)
{
    return IsWithinReach(a.x) && IsWithinReach(a.y);
}

/// Clamps a coordinate to the limits; 0 for NaN.
inline double WithinReach(double a)
{
    const double reach = kReach;
    return a > reach ? reach : a < -reach ? -reach : a == a ? a : 0.0;
}

} // namespace box2d
