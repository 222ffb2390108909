// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

/// Numbers the islands that are awake in a step from 0 on, so that arrays by island are as small as
/// possible. Arrays over all islands would have to be cleared in each step, at a cost for sleeping
/// bodies.
namespace box2d
{

class World;

class AwakeIslands
{
public:
    /// The numbers are valid until an island or the list of awake bodies changes.
    void Find(const World& world);
    /// Brings the awake bodies into the order of the numbers of their islands, those without one
    /// first. Call after Find; numbers by body are then invalid.
    void SortBodies(World& world);

    int32 Count() const { return int32(m_islands.size()); }
    /// The number of an island of Islands; -1 for one that sleeps or does not exist.
    int32 NumberOf(int32 island) const
    {
        return std::size_t(island) < m_numberOf.size() ? m_numberOf[std::size_t(island)] : -1;
    }
    /// Returns the number by solver index of a body; -1 without an island.
    int32 Of(int32 body) const { return m_ofBody[std::size_t(body)]; }
    /// Returns the island with this number.
    int32 At(int32 number) const { return m_islands[std::size_t(number)]; }

private:
    Array<int32> m_islands;
    Array<int32> m_numberOf; // by island; -1 except for those of m_islands
    Array<int32> m_ofBody;   // by solver index
    Array<b2Body*> m_sorted; // scratch
    Array<int32> m_next;     // scratch: by number plus 1, the place of the next body
};

} // namespace box2d
