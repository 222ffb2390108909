// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/b2Fixture.h>

/// Finds the shapes in a view, for debug drawing. Uses the broad phase, so invisible shapes cost no
/// time. Only reads the world.
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
