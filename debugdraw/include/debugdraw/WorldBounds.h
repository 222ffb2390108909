// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>

#include <vector>

/// @file
/// Where the things of a world are, for a camera that keeps them in view. Only reads the world.
namespace boxreel
{

/// What should be seen before the first step [m]: everything that can move and where its joints are
/// anchored, and of the static surroundings as much as lies near it; and `extra`, what is drawn
/// beside the world. Never empty.
Rect BoundsAtStart(const b2World& world, const Rect& extra = {});

/// All there is, the static surroundings and the anchors of joints too [m], and `extra`. Never
/// empty.
Rect BoundsOfEverything(const b2World& world, const Rect& extra = {});

/// Of these bodies [m], null ones left out; empty if there are none. A body without shapes counts
/// as a point.
Rect BoundsOfBodies(const std::vector<const b2Body*>& bodies);

/// Of their centres of mass alone [m].
Rect BoundsOfCenters(const std::vector<const b2Body*>& bodies);

/// The boxes of the bodies that are in motion [m], one a body.
std::vector<Rect> BoundsOfMovers(const b2World& world);

} // namespace boxreel
