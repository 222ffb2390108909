// SPDX-License-Identifier: MIT
#include "ListMatch.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace boxreel
{
namespace
{

// Maximum number of inserted or removed items to look ahead. More is slower where everything moves;
// less treats items after a larger change as changed.
constexpr std::size_t kLookAhead = 24;

class Matcher
{
public:
    Matcher(const DrawList& last, const DrawList& next) : m_last(last), m_next(next) {}

    void Run(std::vector<std::size_t>& matches)
    {
        matches.assign(m_next.items.size(), kNoMatch);
        std::size_t i = 0;
        std::size_t k = 0;
        while (i < m_last.items.size() && k < m_next.items.size())
        {
            if (IsSame(i, k))
            {
                matches[k++] = i++;
                continue;
            }
            const Step step = AfterDifference(i, k);
            i += step.last;
            k += step.next;
        }
    }

private:
    struct Step
    {
        std::size_t last;
        std::size_t next;
    };

    bool IsSame(std::size_t i, std::size_t k) const
    {
        const DrawItem& a = m_last.items[i];
        const DrawItem& b = m_next.items[k];
        return a.kind == b.kind && a.count == b.count && a.color == b.color && a.role == b.role &&
               std::bit_cast<std::uint32_t>(a.size) == std::bit_cast<std::uint32_t>(b.size) &&
               std::memcmp(m_last.points.data() + a.first, m_next.points.data() + b.first,
                           a.count * sizeof(Vec2)) == 0 &&
               (a.kind != DrawKind::Text || m_last.texts[a.text] == m_next.texts[b.text]);
    }

    /// Returns the smallest step to the next match: one changed item, or some inserted or removed.
    Step AfterDifference(std::size_t i, std::size_t k) const
    {
        const DrawItem& a = m_last.items[i];
        const DrawItem& b = m_next.items[k];
        const bool isOwned = a.owner != kNoOwner && a.owner == b.owner;
        if (isOwned && a.kind == b.kind && a.layer == b.layer)
        {
            return {1, 1}; // the same shape at another position
        }
        const std::size_t lastLeft = m_last.items.size() - i;
        const std::size_t nextLeft = m_next.items.size() - k;
        if (lastLeft > 1 && nextLeft > 1 && IsSame(i + 1, k + 1))
        {
            return {1, 1};
        }
        for (std::size_t ahead = 1; ahead <= kLookAhead; ++ahead)
        {
            if (ahead < lastLeft && IsSame(i + ahead, k))
            {
                return {ahead, 0};
            }
            if (ahead < nextLeft && IsSame(i, k + ahead))
            {
                return {0, ahead};
            }
        }
        return {1, 1};
    }

    const DrawList& m_last;
    const DrawList& m_next;
};

} // namespace

void MatchItems(const DrawList& last, const DrawList& next, std::vector<std::size_t>& matches)
{
    Matcher(last, next).Run(matches);
}

} // namespace boxreel
