// SPDX-License-Identifier: MIT
#pragma once

#include <string>

class b2World;

/// Walks over everything a world keeps and compares each thing with all others that say the same:
/// lists with counts, flags with lists, colours with masks, islands with links, boxes with trees.
namespace dynamics
{

/// What is wrong, as a sentence; empty when nothing is. `afterStep`: also what holds between a step
/// and the next call only.
std::string WhyBroken(b2World& world, bool afterStep);

} // namespace dynamics
