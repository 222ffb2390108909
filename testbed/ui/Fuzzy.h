// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Finding a name by a few of its letters: "npyr" finds "Many Pyramids".
namespace boxreel
{

struct FuzzyMatch
{
    int score = 0;                    ///< the higher the better
    std::vector<std::size_t> letters; ///< of the name that the query's fall on, in order
};

/// None when the query's letters and digits do not all come in the name, in their order; case,
/// blanks and punctuation are overlooked. An empty query matches everything with 0. Letters that
/// begin words count more than others, and so do letters in a row; of names that match as well the
/// shorter has the higher score.
std::optional<FuzzyMatch> MatchFuzzily(std::string_view query, std::string_view name);

/// The places in `names` of those that match, best first; as they come where equal.
std::vector<std::size_t> FindFuzzily(std::string_view query,
                                     const std::vector<std::string_view>& names);

} // namespace boxreel
