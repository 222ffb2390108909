// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

#include <cstddef>

/// Contacts whose impulses nothing requires. Such contacts contradict each other, or they hold each
/// other by friction. ContactSystem then makes them soft.
namespace box2d
{

class BoundedSystem;

/// True if the constraints of the first `contacts` items are contradictory: bodies become too fast,
/// or impulses exceed what the pusher and weight require. `driven` is the pusher's speed [m/s],
/// `weight` the speed that weight adds in a kick [m/s].
bool IsJammed(BoundedSystem& system, std::size_t contacts, const SolverContext& context,
              double driven, double weight);

/// True if the contacts of two bodies hold each other by friction with impulses that nothing
/// requires: neither the motion of the bodies nor what else acts on them.
bool IsWedged(BoundedSystem& system, std::size_t contacts, const SolverContext& context,
              double weight);

} // namespace box2d
