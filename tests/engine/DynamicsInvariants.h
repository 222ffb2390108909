// SPDX-License-Identifier: MIT
#pragma once

#include <string>

class b2World;

/// Visits all data of a world and compares redundant parts: lists with counts, flags with lists,
/// colours with masks, islands with links, boxes with trees.
namespace dynamics
{

/// Returns the broken invariant as a sentence; empty if all hold. `afterStep`: also checks those
/// that hold only between a step and the next call.
std::string WhyBroken(b2World& world, bool afterStep);

} // namespace dynamics
