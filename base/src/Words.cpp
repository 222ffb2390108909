// SPDX-License-Identifier: MIT
#include <base/Words.h>

namespace boxreel
{

std::vector<std::string> SplitAt(char separator, std::string_view text)
{
    std::vector<std::string> parts(1);
    for (const char c : text)
    {
        if (c == separator)
        {
            parts.emplace_back();
        }
        else
        {
            parts.back() += c;
        }
    }
    return parts;
}

std::string JoinedBy(std::string_view separator, const std::vector<std::string>& words)
{
    return JoinedBy(separator, words,
                    [](const std::string& word) -> const std::string& { return word; });
}

} // namespace boxreel
