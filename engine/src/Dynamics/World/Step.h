// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

namespace box2d
{

class World;

/// Performs one step. It finds and updates contacts, solves velocities, moves bodies, and solves
/// positions. Then it looks for impacts that the discrete step would miss, and puts bodies at rest
/// to sleep.
void Step(World& world, float32 timeStep, int32 velocityIterations, int32 positionIterations);
void ClearForces(World& world);

} // namespace box2d
