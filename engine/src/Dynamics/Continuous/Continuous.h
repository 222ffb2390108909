// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

namespace box2d
{

class World;

/// Finds and solves the impacts that a step would miss, in the order of their time.
void SolveContinuous(World& world, float32 timeStep, int32 velocityIterations);

} // namespace box2d
