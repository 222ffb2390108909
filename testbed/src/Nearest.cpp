// SPDX-License-Identifier: MIT
#include "Nearest.h"

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
    // One mistake in three letters still looks like the word; more is a guess that would mislead.
    const int limit = std::max(1, static_cast<int>(word.size()) / 3);
    int nearest = -1;
    int nearestDistance = limit + 1;
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
        int distance = EditDistance(word, candidates[i]);
        if (word.size() >= 3 && candidates[i].starts_with(word))
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

} // namespace boxreel
