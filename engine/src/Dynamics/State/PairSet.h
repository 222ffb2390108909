// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>

#include <cstdint>

/// The set of proxy pairs with a contact, so that the broad phase reports each pair once. Open
/// addressing with linear probing and backward-shift deletion (Knuth, TAOCP 3, 6.4). It is never
/// iterated, so its order cannot affect the simulation.
namespace box2d
{

class PairSet
{
public:
    /// Reserves room for `count` pairs in an empty set.
    void Reserve(std::size_t count);
    /// A new pair.
    void Insert(std::int32_t proxyA, std::int32_t proxyB);
    /// A pair of the set.
    void Erase(std::int32_t proxyA, std::int32_t proxyB);
    bool Contains(std::int32_t proxyA, std::int32_t proxyB) const;

private:
    static std::uint64_t Key(std::int32_t proxyA, std::int32_t proxyB);
    std::size_t Home(std::uint64_t key) const;
    std::size_t Find(std::uint64_t key) const;
    void Grow();

    Array<std::uint64_t> m_slots; // 0: empty; the size is a power of two
    std::size_t m_count = 0;
};

} // namespace box2d
