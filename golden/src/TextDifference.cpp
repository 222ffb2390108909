// SPDX-License-Identifier: MIT
#include "TextDifference.h"

#include "TextLines.h"

namespace boxreel
{

namespace
{

std::optional<std::string> Copy(const std::optional<std::string_view>& line)
{
    return line ? std::optional<std::string>(*line) : std::nullopt;
}

std::size_t CountLines(std::string_view text)
{
    std::size_t count = 0;
    while (TakeLine(text))
    {
        ++count;
    }
    return count;
}

} // namespace

std::optional<LineDifference> FirstDifference(std::string_view expected, std::string_view actual)
{
    if (expected == actual)
    {
        return std::nullopt;
    }
    const std::size_t expectedLines = CountLines(expected);
    const std::size_t actualLines = CountLines(actual);
    for (std::size_t number = 1;; ++number)
    {
        const auto a = TakeLine(expected);
        const auto b = TakeLine(actual);
        if (a != b || (!a && !b))
        {
            return LineDifference{number, Copy(a), Copy(b), expectedLines, actualLines};
        }
    }
}

} // namespace boxreel
