// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// How far joints are closed after a drift, in small steps.
namespace box2d
{

/// A joint that a drift opens by less than this [m], [rad] is closed well enough at once: the rows,
/// being those of before the drift, leave some hundredths of it.
inline constexpr float32 kNearlyClosed = 1e-4f;
inline constexpr int32 kMostCloses = 3;

/// What may be left after a drift of what was open before it. A small gap is closed at once. A
/// large one, of joints that are only swept over or were made open, would give velocities that
/// stay.
inline float32 Left(float32 before)
{
    return b2Abs(before) <= kNearlyClosed ? 0.0f : 0.8f * before;
}

} // namespace box2d
