// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <cstddef>
#include <vector>

/// Matches the items of a draw list with those of the previous one. Pure; called by Renderer.
namespace boxreel
{

inline constexpr std::size_t kNoMatch = std::size_t(-1);

/// Finds for each item of `next` an identical item of `last`, bit for bit except layer and owner,
/// or kNoMatch. Matches are ascending, so in areas with only matched items both lists show the
/// same. Unchanged items are found between inserted, removed and changed ones, though not always
/// the maximum. Takes linear time.
void MatchItems(const DrawList& last, const DrawList& next, std::vector<std::size_t>& matches);

} // namespace boxreel
