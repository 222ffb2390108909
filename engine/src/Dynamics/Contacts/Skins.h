// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Internal/ContactData.h>

namespace box2d
{

struct World;

/// Overlap of skins that are left or made thinner [m]. The direct solution of overlaps starts at
/// 0.95 slops, and rounding or a small load does not bring them there at once. From 0.5 to 0.9
/// slops an arch sinks by 5.9 to 5.4 cm; with 1 the solution starts at once
/// (docs/notes/placed-shapes.md).
inline constexpr float32 kRestOverlap = 0.8f * b2_linearSlop;

/// Sets the share of the skins that keeps apart two shapes, and their radii. To be called after the
/// manifold has been computed. Skins that a program has put into each other are thinner for as long
/// as the shapes touch. What it has put together then stays where it is. Pushed apart by their
/// skins, card houses would fall. The shapes themselves are pushed apart all the same. On a body
/// that is not dynamic, that holds only well within one of its shapes.
///
/// `bInA`: frame of body B relative to body A's. `isFirst`: the bodies have not moved in this step.
void UpdateSkins(const World& world, ContactData& c, const b2Transform& bInA, bool isFirst);

} // namespace box2d
