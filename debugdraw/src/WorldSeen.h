// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/View.h>

#include <vector>

/// Selects the bodies that a picture may show. Bodies at rest elsewhere are not visited.
namespace boxreel
{

/// Returns the visible bodies, oldest first; all of them without an area. With an area: awake
/// bodies, bodies with joints, and those with a shape in the picture or up to `reachPixels` beside
/// it. A sleeping body without joints is skipped if none of its shapes is near the picture.
std::vector<const b2Body*> SeenBodies(const b2World& world, const View& view, double reachPixels);

/// Returns the bodies that SeenBodies has wherever their shapes are, oldest first.
std::vector<const b2Body*> BodiesSeenAnywhere(const b2World& world);

/// Returns the bodies that can move and are awake, oldest first.
std::vector<const b2Body*> AwakeBodies(const b2World& world);

} // namespace boxreel
