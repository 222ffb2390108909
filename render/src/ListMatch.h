// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <cstddef>
#include <vector>

/// Which items of a draw list are those of the one before. Pure; called by Renderer.
namespace boxreel
{

inline constexpr std::size_t kNoMatch = std::size_t(-1);

/// For each item of `next` an item of `last` that shows the same (bit for bit; layer and owner do
/// not matter), or kNoMatch. Ascending but for those, so where only matched items lie, both lists
/// show the same things in the same order. Finds what stayed although things around it came, went
/// or changed, but not always the most that can be found; takes time proportional to the items.
void MatchItems(const DrawList& last, const DrawList& next, std::vector<std::size_t>& matches);

} // namespace boxreel
