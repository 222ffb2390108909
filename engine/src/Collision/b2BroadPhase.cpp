// SPDX-License-Identifier: MIT
#include <Box2D/Collision/b2BroadPhase.h>

#include <algorithm>

int32 b2BroadPhase::CreateProxy(const b2AABB& aabb, void* userData)
{
    const int32 proxyId = m_tree.CreateProxy(aabb, userData);
    m_moved.push_back(proxyId);
    return proxyId;
}

void b2BroadPhase::DestroyProxy(int32 proxyId)
{
    // Its number may remain in m_moved. CollectPairs skips numbers that are not proxies, and a
    // reused number had to be tested anyway.
    m_tree.DestroyProxy(proxyId);
}

void b2BroadPhase::MoveProxy(int32 proxyId, const b2AABB& aabb, const b2Vec2& displacement)
{
    if (m_tree.MoveProxy(proxyId, aabb, displacement))
    {
        m_moved.push_back(proxyId);
    }
}

void b2BroadPhase::TouchProxy(int32 proxyId)
{
    m_moved.push_back(proxyId);
}

void b2BroadPhase::CollectPairs()
{
    m_pairs.clear();
    std::sort(m_moved.begin(), m_moved.end());
    m_moved.erase(std::unique(m_moved.begin(), m_moved.end()), m_moved.end());
    for (const int32 moved : m_moved)
    {
        if (!m_tree.IsProxy(moved))
        {
            continue;
        }
        m_tree.ForEachOverlap(m_tree.GetFatAABB(moved), [this, moved](int32 other) {
            if (other != moved)
            {
                m_pairs.push_back({b2Min(moved, other), b2Max(moved, other)});
            }
            return true;
        });
    }
    m_moved.clear();

    std::sort(m_pairs.begin(), m_pairs.end(), [](const b2Pair& a, const b2Pair& b) {
        return a.proxyIdA != b.proxyIdA ? a.proxyIdA < b.proxyIdA : a.proxyIdB < b.proxyIdB;
    });
    const auto isSame = [](const b2Pair& a, const b2Pair& b) {
        return a.proxyIdA == b.proxyIdA && a.proxyIdB == b.proxyIdB;
    };
    m_pairs.erase(std::unique(m_pairs.begin(), m_pairs.end(), isSame), m_pairs.end());
}

int32 b2BroadPhase::GetProxyCount() const
{
    int32 count = 0;
    for (int32 tree = 0; tree < m_treeCount; ++tree)
    {
        count += m_trees[tree].GetProxyCount();
    }
    return count;
}

int32 b2BroadPhase::GetTreeHeight() const
{
    int32 height = 0;
    for (int32 tree = 0; tree < m_treeCount; ++tree)
    {
        height = b2Max(height, m_trees[tree].GetHeight());
    }
    return height;
}

int32 b2BroadPhase::GetTreeBalance() const
{
    int32 balance = 0;
    for (int32 tree = 0; tree < m_treeCount; ++tree)
    {
        balance = b2Max(balance, m_trees[tree].GetMaxBalance());
    }
    return balance;
}

float32 b2BroadPhase::GetTreeQuality() const
{
    float32 quality = 0.0f;
    for (int32 tree = 0; tree < m_treeCount; ++tree)
    {
        quality = b2Max(quality, m_trees[tree].GetAreaRatio());
    }
    return quality;
}
