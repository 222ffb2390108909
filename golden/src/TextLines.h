// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace boxreel
{

/// Removes the first line from `rest` and returns it; none if it is empty.
inline std::optional<std::string_view> TakeLine(std::string_view& rest)
{
    if (rest.empty())
    {
        return std::nullopt;
    }
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return line;
}

/// Returns the start of a line in quotation marks, for messages. Characters other than printable
/// ASCII become `?`, because the line may come from any file or program.
inline std::string Shown(std::string_view line)
{
    std::string text(line.substr(0, 80));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return '"' + text + '"';
}

} // namespace boxreel
