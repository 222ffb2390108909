// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/b2Fixture.h>

/// Which shapes lie in a view, for the debug drawing. Found by the broad phase, so what is not seen
/// costs nothing. Only reads the world.
namespace box2d
{

class World;

struct SeenChild
{
    int32 body = 0; ///< its number
    const b2Fixture* fixture = nullptr;
    int32 child = 0;
};

/// Oldest body first, the fixtures of each in the order of its list.
Array<SeenChild> FindSeen(const World& world, const b2AABB& view);

} // namespace box2d
