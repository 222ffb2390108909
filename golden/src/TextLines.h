// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace boxreel
{

/// Cuts the first line off `rest`; none when nothing is left.
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

/// The beginning of a line in quotation marks, to be shown to a person: what is not printable ASCII
/// becomes `?`, for the line may be of any file or program.
inline std::string Shown(std::string_view line)
{
    std::string text(line.substr(0, 80));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return '"' + text + '"';
}

} // namespace boxreel
