// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>
#include <string_view>
#include <vector>

/// @file
/// Finds the likely meaning of a mistyped word, for the error that refuses it.
namespace boxreel
{

/// Returns the number of letters to insert, delete, replace, or swap with their neighbour to turn
/// `a` into `b`.
int EditDistance(std::string_view a, std::string_view b);

/// Returns the index of the candidate nearest to `word`, or -1 if none is near enough. Case is
/// ignored. A candidate that starts with the word counts as near.
int NearestWord(std::string_view word, const std::vector<std::string>& candidates);

/// Returns the remedy of an Error: "did you mean 'high'?" if a candidate is near, otherwise
/// `otherwise`.
std::string DidYouMean(std::string_view word, const std::vector<std::string>& candidates,
                       const std::string& otherwise = "");

/// Refuses a value that must be one of a few (Unusable).
Error NotOneOf(const std::string& option, const std::string& text,
               const std::vector<std::string>& words);

} // namespace boxreel
