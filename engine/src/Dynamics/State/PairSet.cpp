// SPDX-License-Identifier: MIT
#include "PairSet.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace box2d
{

namespace
{

/// A power of two, because slots are found by a mask. Half of them can be used before the set
/// grows; a larger number would only make the set of a small world larger.
constexpr std::size_t kFirstSlots = 64;

} // namespace

// Both halves are the proxy plus one, so that no key is 0.
std::uint64_t PairSet::Key(std::int32_t proxyA, std::int32_t proxyB)
{
    if (proxyA > proxyB)
    {
        std::swap(proxyA, proxyB);
    }
    return (std::uint64_t(std::uint32_t(proxyA) + 1u) << 32) |
           std::uint64_t(std::uint32_t(proxyB) + 1u);
}

// Fibonacci hashing (Knuth, TAOCP 3, 6.4) with a fold, so that both halves affect the low bits.
std::size_t PairSet::Home(std::uint64_t key) const
{
    const std::uint64_t product = key * 0x9E3779B97F4A7C15ull;
    return std::size_t(product ^ (product >> 32)) & (m_slots.size() - 1);
}

std::size_t PairSet::Find(std::uint64_t key) const
{
    std::size_t slot = Home(key);
    while (m_slots[slot] != 0 && m_slots[slot] != key)
    {
        slot = (slot + 1) & (m_slots.size() - 1);
    }
    return slot;
}

bool PairSet::Contains(std::int32_t proxyA, std::int32_t proxyB) const
{
    return !m_slots.empty() && m_slots[Find(Key(proxyA, proxyB))] != 0;
}

void PairSet::Reserve(std::size_t count)
{
    m_slots.assign(std::max(kFirstSlots, std::bit_ceil(2 * (count + 1))), 0);
}

void PairSet::Insert(std::int32_t proxyA, std::int32_t proxyB)
{
    if (2 * (m_count + 1) > m_slots.size())
    {
        Grow();
    }
    const std::uint64_t key = Key(proxyA, proxyB);
    m_slots[Find(key)] = key;
    ++m_count;
}

void PairSet::Erase(std::int32_t proxyA, std::int32_t proxyB)
{
    const std::size_t mask = m_slots.size() - 1;
    std::size_t hole = Find(Key(proxyA, proxyB));
    --m_count;
    // Close the gap: a later entry of the same run moves up unless its home is behind the hole.
    for (std::size_t slot = (hole + 1) & mask; m_slots[slot] != 0; slot = (slot + 1) & mask)
    {
        const std::size_t home = Home(m_slots[slot]);
        if (((slot - home) & mask) >= ((slot - hole) & mask))
        {
            m_slots[hole] = m_slots[slot];
            hole = slot;
        }
    }
    m_slots[hole] = 0;
}

void PairSet::Grow()
{
    Array<std::uint64_t> old(m_slots.empty() ? kFirstSlots : 2 * m_slots.size(), 0);
    old.swap(m_slots);
    for (const std::uint64_t key : old)
    {
        if (key != 0)
        {
            m_slots[Find(key)] = key;
        }
    }
}

} // namespace box2d
