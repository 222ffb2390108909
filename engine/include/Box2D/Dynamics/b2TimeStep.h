// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// Where the time of the last step went [ms]. Measured from the first call of b2World::GetProfile
/// on.
struct b2Profile
{
    float32 step = 0.0f;
    float32 collide = 0.0f;
    float32 solve = 0.0f;
    float32 solveInit = 0.0f;
    float32 solveVelocity = 0.0f;
    float32 solvePosition = 0.0f;
    float32 broadphase = 0.0f;
    float32 solveTOI = 0.0f;
};
