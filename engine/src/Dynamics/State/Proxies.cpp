// SPDX-License-Identifier: MIT
#include "Proxies.h"

namespace box2d
{

namespace
{

/// Smaller trees are good enough without a rebuild. Of 20,000 boxes a rebuild spares a ray 13 of 31
/// nodes (docs/notes/collision-speed.md), but a tree of less than 1000 is some ten levels high.
constexpr int32 kMinAdded = 1000;

/// From this number of moves on, and this share of all proxies, a new tree is cheaper than moving
/// each leaf. Bullets' leaves are moved in every step, so they gain earlier. For others fewer moves
/// would gain too little to give up the better tree of single moves. With a half to a seventh of
/// all instead of a third, rain takes the same time within 2 % (docs/notes/collision-speed.md).
/// A new tree for bullets costs or saves instructions of a step as follows. Of 64 bullets that meet
/// no other body it takes 0.93, 1.02 and 1.16 for 4, 5 and 7 other bodies per bullet. Of 32 bullets
/// that meet others it takes 0.89 even for 10. The share is between these.
/// The minimum numbers keep the order of contacts of small worlds, and with it their bits. They
/// save no time: from 4 bullets and from 16 other bodies on, a new tree already takes fewer
/// instructions.
constexpr int32 kMinMoved = 256;
constexpr int32 kMovedShare = 3;
constexpr int32 kMinBullets = 16;
constexpr int32 kBulletShare = 8;
/// Steps between rebuilds of such a tree; with more its boxes overlap too much. With 1, 2, 3, 4 and
/// 6 steps 500 bullets take 1.75, 1.62, 1.61, 1.62 and 1.69 million instructions
/// (docs/notes/collision-speed.md).
constexpr int32 kRebuildPeriod = 3;

} // namespace

int32 Proxies::Create(const b2AABB& fatBox, Mobility mobility, b2FixtureProxy* proxy,
                      uint16 categories)
{
    const int32 tree = int32(mobility);
    const int32 node = m_trees[tree].CreateProxyExact(fatBox, proxy);
    if (m_marks[tree].size() <= std::size_t(node))
    {
        m_marks[tree].resize(std::size_t(node) + 1, kAtRest);
        m_categories[tree].resize(std::size_t(node) + 1, 0);
    }
    m_categories[tree][std::size_t(node)] = categories;
    Count(tree, categories, 1);
    const int32 proxyId = (node << 2) | tree;
    Touch(proxyId);
    ++m_count;
    m_staticAdded += mobility == Mobility::Static;
    return proxyId;
}

void Proxies::Destroy(int32 proxyId)
{
    m_marks[proxyId & 3][std::size_t(proxyId >> 2)] = kAtRest;
    Count(proxyId & 3, m_categories[proxyId & 3][std::size_t(proxyId >> 2)], -1);
    Tree(proxyId).DestroyProxy(proxyId >> 2);
    --m_count;
}

void Proxies::SetCategories(int32 proxyId, uint16 categories)
{
    uint16& known = m_categories[proxyId & 3][std::size_t(proxyId >> 2)];
    Count(proxyId & 3, known, -1);
    known = categories;
    Count(proxyId & 3, known, 1);
}

void Proxies::Count(int32 tree, uint16 categories, int32 change)
{
    for (int32 bit = 0; bit < 16; ++bit)
    {
        const auto mask = uint16(1u << bit);
        if ((categories & mask) != 0)
        {
            m_categoryCounts[tree][bit] += change;
            const bool present = m_categoryCounts[tree][bit] > 0;
            m_present[tree] = uint16(present ? m_present[tree] | mask : m_present[tree] & ~mask);
        }
    }
}

void Proxies::Move(int32 proxyId, const b2AABB& fatBox)
{
    if (m_rebuilds && MobilityOf(proxyId) == Mobility::Dynamic)
    {
        Tree(proxyId).SetProxyAABBForRebuild(proxyId >> 2, fatBox);
    }
    else
    {
        Tree(proxyId).SetProxyAABB(proxyId >> 2, fatBox);
    }
    Touch(proxyId);
}

void Proxies::Grow(int32 proxyId, const b2AABB& fatBox)
{
    Tree(proxyId).EnlargeProxy(proxyId >> 2, fatBox);
    Touch(proxyId);
}

void Proxies::BeginMoves(int32 count, int32 bullets)
{
    const int32 all = TreeOf(Mobility::Dynamic).GetProxyCount();
    m_rebuilds = (count >= kMinMoved && count >= all / kMovedShare) ||
                 (bullets >= kMinBullets && bullets >= all / kBulletShare);
}

void Proxies::EndMoves()
{
    if (m_rebuilds)
    {
        m_rebuilds = false;
        m_rebuilt = true;
        b2DynamicTree& tree = m_trees[int32(Mobility::Dynamic)];
        m_refits = (m_refits + 1) % kRebuildPeriod;
        m_refits == 1 ? tree.RebuildEvenly() : tree.RefitAll();
    }
}

void Proxies::Touch(int32 proxyId)
{
    uint8& mark = m_marks[proxyId & 3][std::size_t(proxyId >> 2)];
    if (mark != kMoved)
    {
        mark = kMoved;
        m_moved.push_back(proxyId);
    }
}

void Proxies::RebuildStatic()
{
    b2DynamicTree& tree = m_trees[int32(Mobility::Static)];
    if (m_staticAdded >= kMinAdded && m_staticAdded >= tree.GetProxyCount() / 2)
    {
        tree.RebuildBottomUp();
        m_staticAdded = 0;
    }
}

void Proxies::ListMoved()
{
    std::size_t count = 0;
    for (const int32 moved : m_moved)
    {
        uint8& mark = m_marks[moved & 3][std::size_t(moved >> 2)];
        if (mark == kMoved) // otherwise destroyed since, or a duplicate of a reused number
        {
            mark = kLookedFor;
            m_moved[count++] = moved;
        }
    }
    m_moved.resize(count);
}

void Proxies::ShiftOrigin(const b2Vec2& newOrigin)
{
    for (b2DynamicTree& tree : m_trees)
    {
        tree.ShiftOrigin(newOrigin);
    }
}

} // namespace box2d
