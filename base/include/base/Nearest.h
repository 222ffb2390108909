// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>
#include <string_view>
#include <vector>

/// @file
/// What a mistyped word was probably meant to be, for the sentence that refuses it.
namespace boxreel
{

/// Letters to insert, delete, replace, or swap with their neighbour to turn `a` into `b`.
int EditDistance(std::string_view a, std::string_view b);

/// Index of the candidate nearest to `word`, or -1 when none is near enough to be meant. Capitals
/// count as small letters, and a candidate that begins with the word as near.
int NearestWord(std::string_view word, const std::vector<std::string>& candidates);

/// "did you mean 'high'?" when a candidate is near, else nothing.
std::string DidYouMean(std::string_view word, const std::vector<std::string>& candidates);

/// "did you mean 'high'? Give one of …" when a candidate is near, else "give one of …": what a
/// refusal goes on with. `remedy` begins with a small letter.
std::string Suggesting(std::string_view word, const std::vector<std::string>& candidates,
                       const std::string& remedy);

/// Why a value is refused that has to be one of a few (Unusable): "--quality 'hihg': did you mean
/// 'high'? Give one of draft, standard, high, lossless."
Error NotOneOf(const std::string& option, const std::string& text,
               const std::vector<std::string>& words);

} // namespace boxreel
