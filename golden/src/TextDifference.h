// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// The first difference of two texts, line by line, for messages. Independent of their meaning.
namespace boxreel
{

/// Without either line, the texts differ only in the newline at their end.
struct LineDifference
{
    std::size_t line = 0;                ///< counted from 1
    std::optional<std::string> expected; ///< none: the expected text ends before this line
    std::optional<std::string> actual;   ///< none: the actual text ends before this line
    std::size_t expectedLines = 0;       ///< in the whole text
    std::size_t actualLines = 0;
};

/// Returns the first difference; none if the texts are equal.
std::optional<LineDifference> FirstDifference(std::string_view expected, std::string_view actual);

/// Returns `line 3 is "…" instead of "…"`, and the numbers of lines if they differ.
std::string Describe(const LineDifference& difference);

} // namespace boxreel
