// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// @file
/// Shares of a step, and where its time went.

/// What each small step gets of a count of iterations that b2World::Step is given for the whole
/// step, >= 0, `subSteps` being what b2World::SetSubStepCount was told, 1 to 64: an equal share, at
/// least one. A single step gets what it is given.
inline constexpr int32 b2IterationsOfASubStep(int32 iterations, int32 subSteps)
{
    const int32 share = subSteps > 1 ? iterations / subSteps : iterations;
    return subSteps > 1 && share < 1 ? 1 : share;
}

/// Where the time of the last step went [ms]. Measured from the first call of b2World::GetProfile
/// on.
struct b2Profile
{
    float32 step = 0.0f;          ///< all of it
    float32 collide = 0.0f;       ///< updating contacts
    float32 solve = 0.0f;         ///< velocities and positions, the three below and more
    float32 solveInit = 0.0f;     ///< preparing constraints
    float32 solveVelocity = 0.0f; ///< solving velocities
    float32 solvePosition = 0.0f; ///< solving positions
    float32 broadphase = 0.0f;    ///< finding new pairs
    float32 solveTOI = 0.0f;      ///< continuous collision
};
