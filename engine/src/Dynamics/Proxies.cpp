// SPDX-License-Identifier: MIT
#include "Proxies.h"

namespace box2d
{

namespace
{

/// Small trees are good enough as they grow.
constexpr int32 kLeastAdded = 1000;

} // namespace

int32 Proxies::Create(const b2AABB& fatBox, Mobility mobility, b2FixtureProxy* proxy)
{
    const int32 tree = int32(mobility);
    const int32 node = m_trees[tree].CreateProxyExact(fatBox, proxy);
    if (m_marks[tree].size() <= std::size_t(node))
    {
        m_marks[tree].resize(std::size_t(node) + 1, kAtRest);
    }
    const int32 proxyId = (node << 2) | tree;
    Touch(proxyId);
    ++m_count;
    m_staticAdded += mobility == Mobility::Static;
    return proxyId;
}

void Proxies::Destroy(int32 proxyId)
{
    m_marks[proxyId & 3][std::size_t(proxyId >> 2)] = kAtRest;
    Tree(proxyId).DestroyProxy(proxyId >> 2);
    --m_count;
}

void Proxies::Move(int32 proxyId, const b2AABB& fatBox)
{
    Tree(proxyId).SetProxyAABB(proxyId >> 2, fatBox);
    Touch(proxyId);
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
    if (m_staticAdded >= kLeastAdded && m_staticAdded >= tree.GetProxyCount() / 2)
    {
        tree.RebuildBottomUp();
        m_staticAdded = 0;
    }
}

bool Proxies::HasMoved(int32 proxyId) const
{
    return m_marks[proxyId & 3][std::size_t(proxyId >> 2)] != kAtRest;
}

void Proxies::ListMoved()
{
    std::size_t count = 0;
    for (const int32 moved : m_moved)
    {
        uint8& mark = m_marks[moved & 3][std::size_t(moved >> 2)];
        if (mark == kMoved) // else destroyed since, or here a second time under a number used again
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
