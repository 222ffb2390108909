// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Collision/b2DynamicTree.h>
#include <Box2D/Common/Array.h>

/// @file
/// Which proxies may touch.

/// A pair of proxies, the smaller number first.
struct b2Pair
{
    int32 proxyIdA; ///< the smaller number
    int32 proxyIdB; ///< the larger number
};

/// Finds the pairs of proxies that may touch, looking only at those that moved. It does not
/// remember pairs: whoever is told of one keeps it until the boxes no longer overlap.
class b2BroadPhase
{
public:
    enum
    {
        e_nullProxy = -1
    };

    b2BroadPhase() = default;
    b2BroadPhase(const b2BroadPhase&) = delete;
    b2BroadPhase& operator=(const b2BroadPhase&) = delete;

    /// Adds a proxy with this box [m]; its pairs are told by the next UpdatePairs. Returns its
    /// number. Boxes as in b2DynamicTree::CreateProxy.
    int32 CreateProxy(const b2AABB& aabb, void* userData);

    /// Removes a proxy. Its pairs are the caller's to remove. A number of no proxy asserts and
    /// changes nothing, here and below.
    void DestroyProxy(int32 proxyId);

    /// Call this whenever the proxy moves [m]; pairs may be new when it has left its stored box.
    void MoveProxy(int32 proxyId, const b2AABB& aabb, const b2Vec2& displacement);

    /// Has all pairs of this proxy told again by the next UpdatePairs.
    void TouchProxy(int32 proxyId);

    /// The stored box [m].
    const b2AABB& GetFatAABB(int32 proxyId) const { return m_tree.GetFatAABB(proxyId); }
    /// What CreateProxy was given.
    void* GetUserData(int32 proxyId) const { return m_tree.GetUserData(proxyId); }

    /// Do the stored boxes overlap?
    bool TestOverlap(int32 proxyIdA, int32 proxyIdB) const
    {
        return b2TestOverlap(GetFatAABB(proxyIdA), GetFatAABB(proxyIdB));
    }

    int32 GetProxyCount() const { return m_tree.GetProxyCount(); } ///< how many proxies there are

    /// Calls `void callback->AddPair(void* userDataA, void* userDataB)` once for every pair that
    /// has a proxy which moved since the last time, in the order of their numbers.
    template <typename T>
    void UpdatePairs(T* callback);

    /// As in b2DynamicTree.
    template <typename T>
    void Query(T* callback, const b2AABB& aabb) const
    {
        m_tree.Query(callback, aabb);
    }
    /// As in b2DynamicTree.
    template <typename T>
    void RayCast(T* callback, const b2RayCastInput& input) const
    {
        m_tree.RayCast(callback, input);
    }

    /// Of the tree; 0: one proxy or none.
    int32 GetTreeHeight() const { return m_tree.GetHeight(); }
    /// As b2DynamicTree::GetMaxBalance.
    int32 GetTreeBalance() const { return m_tree.GetMaxBalance(); }
    /// As b2DynamicTree::GetAreaRatio.
    float32 GetTreeQuality() const { return m_tree.GetAreaRatio(); }

    /// What was at newOrigin [m] is at zero.
    void ShiftOrigin(const b2Vec2& newOrigin) { m_tree.ShiftOrigin(newOrigin); }

private:
    /// Fills m_pairs, sorted and without repetition, and forgets what moved.
    void CollectPairs();

    b2DynamicTree m_tree;
    box2d::Array<int32> m_moved; ///< may hold a proxy twice, and some that are gone
    box2d::Array<b2Pair> m_pairs;
};

template <typename T>
void b2BroadPhase::UpdatePairs(T* callback)
{
    CollectPairs();
    for (const b2Pair& pair : m_pairs)
    {
        callback->AddPair(m_tree.GetUserData(pair.proxyIdA), m_tree.GetUserData(pair.proxyIdB));
    }
}
