// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// @file
/// Iterations per sub-step, and the timing of a step.

/// Returns the iterations of each sub-step: an equal share of the count given to b2World::Step, at
/// least one. `iterations` >= 0; `subSteps` is the argument of b2World::SetSubStepCount, 1 to 64.
/// Without sub-steps the count is unchanged.
inline constexpr int32 b2IterationsOfASubStep(int32 iterations, int32 subSteps)
{
    const int32 share = subSteps > 1 ? iterations / subSteps : iterations;
    return subSteps > 1 && share < 1 ? 1 : share;
}

/// Timing of the last step [ms]. Measured after the first call of b2World::GetProfile.
struct b2Profile
{
    float32 step = 0.0f;          ///< total
    float32 collide = 0.0f;       ///< updating contacts
    float32 solve = 0.0f;         ///< velocities and positions, including the three below
    float32 solveInit = 0.0f;     ///< preparing constraints
    float32 solveVelocity = 0.0f; ///< solving velocities
    float32 solvePosition = 0.0f; ///< solving positions
    float32 broadphase = 0.0f;    ///< finding new pairs
    float32 solveTOI = 0.0f;      ///< continuous collision
};
