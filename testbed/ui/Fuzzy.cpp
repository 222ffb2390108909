// SPDX-License-Identifier: MIT
#include "Fuzzy.h"

#include <base/Words.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>
#include <utility>

namespace boxreel
{
namespace
{

constexpr int kLetter = 4;
constexpr int kInARow = 6;     // more, for a letter that follows the one before
constexpr int kBeginsWord = 8; // more
constexpr int kNone = std::numeric_limits<int>::min() / 2;

bool IsLetter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

std::string LettersOf(std::string_view text)
{
    std::string letters;
    for (const char c : Lower(text))
    {
        letters += IsLetter(c) ? std::string(1, c) : "";
    }
    return letters;
}

bool BeginsWord(std::string_view name, std::size_t at)
{
    return at == 0 || !IsLetter(name[at - 1]) ||
           (std::isupper(static_cast<unsigned char>(name[at])) != 0 &&
            std::islower(static_cast<unsigned char>(name[at - 1])) != 0);
}

} // namespace

std::optional<FuzzyMatch> MatchFuzzily(std::string_view query, std::string_view name)
{
    const std::string wanted = LettersOf(query);
    if (wanted.empty())
    {
        return FuzzyMatch{};
    }
    // best[q][n]: of the query's first q + 1 letters when the last of them falls on letter n.
    const std::string lower = Lower(name);
    const std::size_t length = name.size();
    std::vector<std::vector<int>> best(wanted.size(), std::vector<int>(length, kNone));
    std::vector<std::vector<std::size_t>> before(wanted.size(), std::vector<std::size_t>(length));
    for (std::size_t q = 0; q < wanted.size(); ++q)
    {
        for (std::size_t n = q; n < length; ++n)
        {
            if (lower[n] != wanted[q])
            {
                continue;
            }
            const int own = kLetter + (BeginsWord(name, n) ? kBeginsWord : 0);
            best[q][n] = q == 0 ? own : kNone;
            for (std::size_t p = q == 0 ? n : 0; p < n; ++p)
            {
                const int score = best[q - 1][p] + own + (p + 1 == n ? kInARow : 0);
                if (best[q - 1][p] != kNone && score > best[q][n])
                {
                    best[q][n] = score;
                    before[q][n] = p;
                }
            }
        }
    }
    const auto last = std::max_element(best.back().begin(), best.back().end());
    if (length == 0 || *last == kNone)
    {
        return std::nullopt;
    }
    FuzzyMatch match;
    match.score = *last - int(length) / 4;
    std::size_t at = std::size_t(last - best.back().begin());
    for (std::size_t q = wanted.size(); q-- > 0; at = before[q][at])
    {
        match.letters.push_back(at);
    }
    std::reverse(match.letters.begin(), match.letters.end());
    return match;
}

std::vector<std::size_t> FindFuzzily(std::string_view query,
                                     const std::vector<std::string_view>& names)
{
    std::vector<std::pair<int, std::size_t>> found; // by the score's negative: the best come first
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        if (const std::optional<FuzzyMatch> match = MatchFuzzily(query, names[i]))
        {
            found.emplace_back(-match->score, i);
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<std::size_t> places;
    for (const auto& [score, place] : found)
    {
        places.push_back(place);
    }
    return places;
}

} // namespace boxreel
