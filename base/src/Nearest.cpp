// SPDX-License-Identifier: MIT
#include <base/Nearest.h>
#include <base/Quoting.h>
#include <base/Words.h>

#include <algorithm>

namespace boxreel
{
int EditDistance(std::string_view a, std::string_view b)
{
    // d[i][j] = distance of the first i letters of a to the first j of b (optimal string alignment,
    // the restricted Damerau-Levenshtein distance); only the last three rows are kept.
    std::vector<int> beforeLast(b.size() + 1);
    std::vector<int> last(b.size() + 1);
    std::vector<int> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
    {
        last[j] = static_cast<int>(j);
    }
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
            {
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
            }
        }
        std::swap(beforeLast, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

int NearestWord(std::string_view word, const std::vector<std::string>& candidates)
{
    // At most one mistake per three letters; a more distant suggestion would mislead. So would a
    // candidate without a common letter.
    const int length = static_cast<int>(word.size());
    const int limit = std::min(std::max(1, length / 3), length - 1);
    const std::string typed = Lower(word);
    int nearest = -1;
    int nearestDistance = limit + 1;
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
        const std::string candidate = Lower(candidates[i]);
        int distance = EditDistance(typed, candidate);
        if (length >= 3 && candidate.starts_with(typed))
        {
            distance = std::min(distance, 1);
        }
        if (distance < nearestDistance)
        {
            nearest = static_cast<int>(i);
            nearestDistance = distance;
        }
    }
    return nearest;
}

std::string DidYouMean(std::string_view word, const std::vector<std::string>& candidates,
                       const std::string& otherwise)
{
    const int nearest = NearestWord(word, candidates);
    return nearest < 0
               ? otherwise
               : "did you mean " + Quoted(candidates[static_cast<std::size_t>(nearest)]) + "?";
}

Error NotOneOf(const std::string& option, const std::string& text,
               const std::vector<std::string>& words)
{
    return Error{ErrorKind::Unusable, AsTyped(option, text),
                 "must be one of " + JoinedBy(", ", words), DidYouMean(text, words)};
}

} // namespace boxreel
