// SPDX-License-Identifier: MIT
#pragma once

#include "SolverMemory.h"

/// Impacts of bodies at walls, in a step without sub-steps. Called once in such a step, before
/// contacts are prepared.
namespace box2d
{

class World;

/// Applies restitution to each body that touches only walls at rest, in two cases. If they form an
/// acute angle, a bounce off one wall drives the body into the other. If one of two points at a
/// wall leaves it while the other one comes, a bounce drives the first one back. The iterations of
/// a step solve all bounces at once. In a narrow wedge they end long before they converge, so the
/// rest of the bounces would be lost. A leaving point would be held at the wall, which adds energy.
/// Impulses of the last step that no longer act would be kept in part. Here one wall after the
/// other pushes the body, as often as needed. It changes the velocities of the solver's bodies, and
/// clears the warm start of these contacts.
void BounceInCorners(const World& world, CornerMemory& memory, const SolverContext& context);

} // namespace box2d
