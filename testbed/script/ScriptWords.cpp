// SPDX-License-Identifier: MIT
#include "ScriptWords.h"

#include <base/Words.h>

namespace boxreel
{
namespace
{

bool IsBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

} // namespace

Result<std::vector<std::string>> WordsOf(std::string_view line)
{
    std::vector<std::string> words;
    bool isInWord = false;
    bool isQuoted = false;
    for (const char c : line)
    {
        if (!isInWord && c == '#')
        {
            break;
        }
        if (IsBlank(c) && !isQuoted)
        {
            isInWord = false;
            continue;
        }
        if (!isInWord)
        {
            words.emplace_back();
            isInWord = true;
        }
        if (c == '"')
        {
            isQuoted = !isQuoted;
        }
        else
        {
            words.back() += c;
        }
    }
    if (isQuoted)
    {
        return Error{ErrorKind::Unusable, "\"", "quote is not closed", "close it on the same line"};
    }
    return words;
}

std::string LineOf(const std::vector<std::string>& words)
{
    return JoinedBy(" ", words, [](const std::string& word) {
        const bool isPlain = !word.empty() && word.find_first_of(" \t#") == std::string::npos;
        return isPlain ? word : '"' + word + '"';
    });
}

} // namespace boxreel
