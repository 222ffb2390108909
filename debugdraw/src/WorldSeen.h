// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/View.h>

#include <vector>

/// Which bodies a picture may say something about. What rests elsewhere is not even looked at.
namespace boxreel
{

/// The oldest first. All of them without an area; with one those that are awake, those that hang on
/// joints, and those of which a shape may be in the picture or at most so many pixels beside it. So
/// a body is left out that has neither shape nor joint, and one that rests around a picture in
/// which nothing of it is.
std::vector<const b2Body*> SeenBodies(const b2World& world, const View& view, double reachPixels);

/// Those that can move and do not sleep, the oldest first.
std::vector<const b2Body*> AwakeBodies(const b2World& world);

} // namespace boxreel
