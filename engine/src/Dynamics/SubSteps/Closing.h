// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// How far joints are closed after a drift, in sub-steps.
namespace box2d
{

/// A joint that a drift opens by less than this [m], [rad] is closed well enough at once: the rows,
/// being those of before the drift, leave some hundredths of it.
inline constexpr float32 kNearlyClosed = 1e-4f;
inline constexpr int32 kMostCloses = 3;

/// What is to be left after a drift of what was open before it: a small gap is closed at once, by
/// velocities, which would stay if they closed a large one, of joints that are only swept over or
/// were made open. Of that a share goes with each drift, by poses alone.
inline float32 Lasting(float32 before)
{
    return b2Abs(before) <= kNearlyClosed ? 0.0f : before;
}
inline constexpr float32 kClosedShare = 0.2f;

} // namespace box2d
