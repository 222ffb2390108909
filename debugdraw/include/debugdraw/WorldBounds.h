// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>

#include <vector>

/// @file
/// Bounding boxes of a world, for cameras. Only reads the world.
namespace boxreel
{

/// Returns the initial view [m]: all moving bodies, the anchors of their joints, nearby static
/// bodies, and `extra` for additional items. Never empty.
Rect BoundsAtStart(const b2World& world, const Rect& extra = {});

/// Returns the bounds of all bodies and joint anchors, static ones included [m], and `extra`. Never
/// empty.
Rect BoundsOfEverything(const b2World& world, const Rect& extra = {});

/// Returns the bounds of these bodies [m]; null pointers are skipped. Empty without bodies. A body
/// without shapes counts as a point.
Rect BoundsOfBodies(const std::vector<const b2Body*>& bodies);

/// Returns the bounds of their centres of mass [m].
Rect BoundsOfCenters(const std::vector<const b2Body*>& bodies);

/// Returns the boxes of the moving bodies [m], one per body.
std::vector<Rect> BoundsOfMovers(const b2World& world);

} // namespace boxreel
