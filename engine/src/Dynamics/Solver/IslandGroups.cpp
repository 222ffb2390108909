// SPDX-License-Identifier: MIT
#include "IslandGroups.h"

#include "../Islands/AwakeIslands.h"

namespace box2d
{

void IslandGroups::Join(int32 bodies)
{
    m_changed = Count() > 1;
    m_wantsOrder = false;
    m_key = kNoKey;
    m_ends.assign(1, End{bodies, 0});
}

bool IslandGroups::Keep(std::uint64_t key)
{
    const bool same = key == m_key;
    m_changed = m_changed && !same;
    return same;
}

void IslandGroups::Divide(const AwakeIslands& islands, int32 bodies, std::uint64_t key)
{
    const bool wasOne = Count() <= 1;
    m_lastOf.assign(std::size_t(islands.Count()), -1);
    m_sizes.assign(std::size_t(islands.Count()), 0);
    for (int32 i = 0; i < bodies; ++i)
    {
        const int32 island = islands.Of(i + 1);
        if (island == -1)
        {
            Join(bodies);
            m_key = key;
            return;
        }
        m_lastOf[std::size_t(island)] = i;
        ++m_sizes[std::size_t(island)];
    }
    const int32 least = b2Max(kBodies, (bodies + kMaxCount - 1) / kMaxCount);
    FindEnds(islands, bodies, least);
    m_wantsOrder = CountInOrder(least) >= 2 * Count();
    m_changed = Count() > 1 || !wasOne;
    m_key = key;
}

/// A group ends where no island goes on. Islands are numbered in the order of their first bodies,
/// so those of a group follow each other.
void IslandGroups::FindEnds(const AwakeIslands& islands, int32 bodies, int32 least)
{
    m_ofBody.resize(std::size_t(bodies));
    m_ends.clear();
    int32 begin = 0;
    int32 reach = 0;
    int32 end = 0;
    for (int32 i = 0; i < bodies; ++i)
    {
        const int32 island = islands.Of(i + 1);
        reach = b2Max(reach, m_lastOf[std::size_t(island)]);
        end = b2Max(end, island + 1);
        m_ofBody[std::size_t(i)] = uint8(m_ends.size());
        if (i + 1 == bodies || (reach == i && i + 1 - begin >= least))
        {
            m_ends.push_back(End{i + 1, end});
            begin = i + 1;
        }
    }
}

/// Returns the number of groups with the bodies in the order of their islands.
int32 IslandGroups::CountInOrder(int32 least) const
{
    int32 count = 0;
    int32 size = 0;
    for (const int32 bodies : m_sizes)
    {
        size += bodies;
        if (size >= least)
        {
            ++count;
            size = 0;
        }
    }
    return count;
}

IslandGroup IslandGroups::At(int32 number) const
{
    const End begin = number > 0 ? m_ends[std::size_t(number) - 1] : End{0, 0};
    const End end = m_ends[std::size_t(number)];
    return {Count() > 1 ? number : -1, begin.body, end.body, begin.island, end.island};
}

} // namespace box2d
