// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Texts taken apart and put together.
namespace boxreel
{

/// Splits at every separator: one more part than there are separators.
std::vector<std::string> SplitAt(char separator, std::string_view text);

/// Returns "a, b, c": the texts that `textOf` returns for the items, with `separator` between them.
template <class Items, class TextOf>
std::string JoinedBy(std::string_view separator, const Items& items, TextOf&& textOf)
{
    std::string text;
    for (const auto& item : items)
    {
        text.append(text.empty() ? "" : separator).append(textOf(item));
    }
    return text;
}

/// Returns "a, b, c": the words with `separator` between them.
std::string JoinedBy(std::string_view separator, const std::vector<std::string>& words);

/// Returns the text with lower-case letters. ASCII only, so that it does not depend on the locale.
std::string Lower(std::string_view text);

/// Returns the text with each {{word}} replaced by the part of that name, which must exist. Text of
/// parts is not replaced.
std::string FilledTemplate(std::string_view text,
                           const std::map<std::string_view, std::string_view>& parts);

} // namespace boxreel
