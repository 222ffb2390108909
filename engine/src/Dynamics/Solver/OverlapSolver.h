// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

namespace box2d
{

struct OverlapBlock;

/// Depth, normal and position of a point's overlap, after the displacements so far in this step.
struct Overlap
{
    b2Vec2 normal; // from A to B
    b2Vec2 armA, armB;
    float32 separation;
};

/// Measures a point of one lane.
Overlap MeasureOverlap(const OverlapBlock& block, int lane, int point, const SolverBody* bodies);

/// The rate of position correction: the fraction of the excess over the slop, limited by `maximum`
/// [m].
struct PushPace
{
    float32 rate;
    float32 maximum = b2_maxLinearCorrection;
};

/// Maximum speed of position correction with sub-steps, by all contacts of a body and its island
/// [m/s]. It is 20 cm per frame, because pushes in a row add up. With half of it, stacks of 50
/// without space for their skins end differently, and free rows separate in 1 s instead of 0.6.
inline constexpr float32 kFarthestPush = 12.0f;

/// Returns the maximum displacement of any point of a body by a push [m].
inline float32 PushOf(const SolverBody& before, const SolverBody& after, float32 maxExtent)
{
    return (after.d - before.d).Length() + b2Abs(after.angle - before.angle) * maxExtent;
}

/// Reduces a push to a fraction of itself in the same direction.
void ShortenPush(const SolverBody& before, SolverBody& after, float32 share);

} // namespace box2d
