// SPDX-License-Identifier: MIT
#include "AwakeIslands.h"

#include "../State/Access.h"
#include "../State/World.h"

#include <Box2D/Dynamics/b2Body.h>

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

} // namespace box2d
