// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

/// The mobile of two scenes, which differ in where its rods hang. Called by them while they build
/// their world.
namespace boxreel
{

/// The point of a rod that its string holds.
enum class HeldAt
{
    Middle,  ///< under any load
    Balance, ///< the point at which both ends pull equally
};

/// Adds a tree of rods and equal balls that hangs from one static point at this height [m]. Each
/// rod carries a greater tree at one end and a smaller one at the other. The balls are in a row
/// about x = 0, and the tree reaches 9 m below the point. Returns the uppermost rod.
b2Body* AddMobile(b2World& world, float32 height, HeldAt held);

} // namespace boxreel
