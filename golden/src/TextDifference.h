// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Where two texts part, line by line, for messages. Knows nothing of what the lines mean.
namespace boxreel
{

/// Without either line, the texts differ by the newline at their end alone.
struct LineDifference
{
    std::size_t line = 0;                ///< counted from 1
    std::optional<std::string> expected; ///< none: the expected text ends before this line
    std::optional<std::string> actual;   ///< none: the actual text ends before this line
    std::size_t expectedLines = 0;       ///< in the whole text
    std::size_t actualLines = 0;
};

/// None when the texts are equal.
std::optional<LineDifference> FirstDifference(std::string_view expected, std::string_view actual);

/// `line 3 is "…" instead of "…"`, and how many lines there are when that changed.
std::string Describe(const LineDifference& difference);

} // namespace boxreel
