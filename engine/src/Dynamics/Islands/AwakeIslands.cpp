// SPDX-License-Identifier: MIT
#include "AwakeIslands.h"

#include "../State/Access.h"
#include "../State/World.h"

#include <Box2D/Dynamics/b2Body.h>

#include <numeric>

namespace box2d
{

void AwakeIslands::Find(const World& world)
{
    for (const int32 island : m_islands)
    {
        m_numberOf[std::size_t(island)] = -1;
    }
    m_islands.clear();
    m_numberOf.resize(b2Max(m_numberOf.size(), std::size_t(world.islands.Size())), -1);
    m_ofBody.assign(world.awakeBodies.size() + 1, -1);
    for (const b2Body* body : world.awakeBodies)
    {
        const BodyData& data = Data(*body);
        if (data.island == -1)
        {
            continue;
        }
        int32& number = m_numberOf[std::size_t(data.island)];
        if (number == -1)
        {
            number = Count();
            m_islands.push_back(data.island);
        }
        m_ofBody[std::size_t(data.SolverIndex())] = number;
    }
}

/// A counting sort.
void AwakeIslands::SortBodies(World& world)
{
    m_next.assign(std::size_t(Count()) + 2, 0);
    for (std::size_t i = 1; i < m_ofBody.size(); ++i)
    {
        ++m_next[std::size_t(m_ofBody[i] + 2)];
    }
    std::partial_sum(m_next.begin(), m_next.end(), m_next.begin());
    m_sorted.resize(world.awakeBodies.size());
    for (b2Body* body : world.awakeBodies)
    {
        BodyData& data = Data(*body);
        data.awakeIndex = m_next[std::size_t(Of(data.SolverIndex()) + 1)]++;
        m_sorted[std::size_t(data.awakeIndex)] = body;
    }
    world.awakeBodies.swap(m_sorted);
    ++world.awakeVersion;
}

} // namespace box2d
