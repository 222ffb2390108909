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
    std::string text;
    for (const std::string& word : words)
    {
        text.append(text.empty() ? "" : separator).append(word);
    }
    return text;
}

} // namespace boxreel
