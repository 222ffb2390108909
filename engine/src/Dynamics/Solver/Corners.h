// SPDX-License-Identifier: MIT
#pragma once

#include "SolverMemory.h"

/// Impacts of bodies in corners, in a step without sub-steps. Called once in such a step, before
/// contacts are prepared.
namespace box2d
{

class World;

/// Applies restitution to each body that touches only walls at rest, where these form an acute
/// angle. A bounce off one wall then drives the body into the other. The iterations of a step
/// solve all bounces at once, and in a narrow wedge they end long before they converge. The rest of
/// the bounces would be lost. Impulses of the last step that no longer act would be kept in part.
/// Here one wall after the other pushes the body, as often as needed. It changes the velocities of
/// the solver's bodies, and clears the warm start of these contacts.
void BounceInCorners(const World& world, CornerMemory& memory, const SolverContext& context);

} // namespace box2d
