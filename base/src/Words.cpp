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

std::string Lower(std::string_view text)
{
    std::string lower(text);
    for (char& c : lower)
    {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return lower;
}

std::string FilledTemplate(std::string_view text,
                           const std::map<std::string_view, std::string_view>& parts)
{
    std::string filled;
    for (;;)
    {
        const std::size_t begin = text.find("{{");
        const std::size_t end = text.find("}}", begin);
        filled += text.substr(0, begin);
        if (begin == std::string_view::npos || end == std::string_view::npos)
        {
            return filled;
        }
        filled += parts.at(text.substr(begin + 2, end - begin - 2));
        text.remove_prefix(end + 2);
    }
}

} // namespace boxreel
