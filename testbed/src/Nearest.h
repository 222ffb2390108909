// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What a mistyped word was probably meant to be.
namespace boxreel
{

/// Letters to insert, delete, replace, or swap with their neighbour to turn `a` into `b`.
int EditDistance(std::string_view a, std::string_view b);

/// Index of the candidate nearest to `word`, or -1 when none is near enough to be meant. A
/// candidate that begins with the word counts as near.
int NearestWord(std::string_view word, const std::vector<std::string>& candidates);

} // namespace boxreel
