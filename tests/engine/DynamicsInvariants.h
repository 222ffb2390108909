// SPDX-License-Identifier: MIT
#pragma once

#include <string>

class b2World;

/// Walks over everything a world keeps and compares each thing with all others that say the same:
/// lists with counts, flags with lists, colours with masks, islands with links, boxes with trees.
namespace dynamics
{

/// Returns the broken invariant as a sentence; empty if all hold. `afterStep`: also checks those
/// that hold only between a step and the next call.
std::string WhyBroken(b2World& world, bool afterStep);

} // namespace dynamics
