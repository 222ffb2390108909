// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// How far the world reaches. Checks of what the program hands over and the bodies themselves keep
/// within it; the solver never looks.
namespace box2d
{

/// Nothing is farther from an origin than this [m]: the squares of distances stay within single
/// precision. Light takes a month for it.
inline constexpr float32 kReach = 1e15f;

/// False for what is no number.
inline bool IsWithinReach(float32 a)
{
    return b2Abs(a) <= kReach;
}

inline bool IsWithinReach(const b2Vec2& a)
{
    return IsWithinReach(a.x) && IsWithinReach(a.y);
}

/// The nearest coordinate within reach; 0 for what is no number.
inline double WithinReach(double a)
{
    const double reach = kReach;
    return a > reach ? reach : a < -reach ? -reach : a == a ? a : 0.0;
}

} // namespace box2d
