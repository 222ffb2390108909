// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>
#include <string_view>
#include <vector>

/// @file
/// Suggestions for mistyped words, for error messages.
namespace boxreel
{

/// Returns the number of letters to insert, delete, replace, or swap with their neighbour to turn
/// `a` into `b`.
int EditDistance(std::string_view a, std::string_view b);

/// Returns the index of the candidate nearest to `word`, or -1 if none is near enough. Case is
/// ignored. A candidate that starts with the word counts as near.
int NearestWord(std::string_view word, const std::vector<std::string>& candidates);

/// Returns "did you mean 'high'?" if a candidate is near, otherwise an empty string.
std::string DidYouMean(std::string_view word, const std::vector<std::string>& candidates);

/// Returns a remedy: "did you mean 'high'? Give one of …" if a candidate is near, otherwise "give
/// one of …". `remedy` starts in lower case.
std::string Suggesting(std::string_view word, const std::vector<std::string>& candidates,
                       const std::string& remedy);

/// Returns the Error (Unusable) for a value outside a list: "--quality 'hihg': did you mean 'high'?
/// Give one of draft, standard, high, lossless."
Error NotOneOf(const std::string& option, const std::string& text,
               const std::vector<std::string>& words);

} // namespace boxreel
