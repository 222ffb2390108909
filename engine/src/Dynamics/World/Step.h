// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

namespace box2d
{

class World;

/// One step: finds and updates contacts, solves velocities, moves, solves positions, looks for
/// impacts that the discrete step would miss, and puts to sleep what has come to rest.
void Step(World& world, float32 timeStep, int32 velocityIterations, int32 positionIterations);
void ClearForces(World& world);

} // namespace box2d
