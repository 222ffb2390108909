// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>

#include <vector>

/// Where the things of a world are, for a camera that keeps them in view. Only reads the world.
namespace boxreel
{

/// What should be seen before the first step [m]: everything that can move and where its joints are
/// anchored, and of the static surroundings as much as lies near it. Never empty.
Rect BoundsAtStart(const b2World& world);

/// The boxes of the bodies that are in motion [m], one a body.
std::vector<Rect> BoundsOfMovers(const b2World& world);

} // namespace boxreel
