// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

/// The islands that are awake in a step, numbered from 0 on: what is kept by island in a step is as
/// large as they are many. Arrays over all islands, which would have to be cleared in each step,
/// make what sleeps cost time.
namespace box2d
{

class World;

class AwakeIslands
{
public:
    /// Once a step. The numbers are right until an island changes.
    void Find(const World& world);

    int32 Count() const { return int32(m_islands.size()); }
    /// The number of an island of Islands; -1 for one that sleeps or does not exist.
    int32 NumberOf(int32 island) const
    {
        return std::size_t(island) < m_numberOf.size() ? m_numberOf[std::size_t(island)] : -1;
    }
    /// By solver index of a body; -1: of none.
    int32 Of(int32 body) const { return m_ofBody[std::size_t(body)]; }
    /// The island with this number.
    int32 At(int32 number) const { return m_islands[std::size_t(number)]; }

private:
    Array<int32> m_islands;
    Array<int32> m_numberOf; // by island; only those of m_islands are not -1
    Array<int32> m_ofBody;   // by solver index
};

} // namespace box2d
