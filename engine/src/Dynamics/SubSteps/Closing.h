// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// The fraction by which joints are closed after a drift, in sub-steps.
namespace box2d
{

/// A joint opened by a drift by less than this [m], [rad] is closed by one solution: a fiftieth of
/// the slop. Its rows are those of before the drift, which leaves a few hundredths of the error.
/// These are some micrometres, as much as kClosed of HingeTreeSolve.cpp leaves. With 3e-4 a chain
/// in steps of 1/60 s gains 1.06 % of energy (2 sub-steps), and seven other tests fail. With 3e-5 a
/// bridge without slack does not come to rest (4 sub-steps).
inline constexpr float32 kNearlyClosed = 1e-4f;
/// A second solution corrects what rotation in the drift has changed, a third what remains after a
/// large one. With one, joints stay open visibly (docs/notes/tuned-constants.md).
inline constexpr int32 kMaxCloses = 3;

/// Iterations that close by poses only. A bound: Newton's method takes few from small gaps, but
/// each closes 0.2 m at most. With 4 a swinging chain of 1000:1 opens by 6 mm instead of 0.1
/// (docs/notes/tuned-constants.md).
inline constexpr int32 kMaxPoseCloses = 12;

/// Returns the part of an initial error that remains after a drift. A small error is closed at once
/// by velocities. For a large one these velocities would persist, so a fraction of it is closed per
/// drift by poses only. Large errors occur in iteratively solved joints, or are created by the
/// program.
inline float32 RemainingError(float32 before)
{
    return b2Abs(before) <= kNearlyClosed ? 0.0f : before;
}
/// Share of a large initial error that a drift closes: b2_baumgarte, as position correction in a
/// whole step. With a smaller one, a hinge that a wall has opened stays open longer. With a larger
/// one, chains of large mass ratios open farther (docs/notes/tuned-constants.md).
inline constexpr float32 kClosedShare = 0.2f;
/// Maximum speed at which a joint beyond its limit returns [m/s], [rad/s]. With 20 that looks like
/// a hit; with 0.2 a violation of 0.5 rad takes seconds (docs/notes/tuned-constants.md).
inline constexpr float32 kFastestReturn = 2.0f;

} // namespace box2d
