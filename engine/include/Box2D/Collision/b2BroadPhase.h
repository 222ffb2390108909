// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Collision/b2DynamicTree.h>
#include <Box2D/Common/Array.h>

/// @file
/// Which proxies may touch.

namespace box2d
{
class World;
} // namespace box2d

/// A pair of proxies, the smaller number first.
struct b2Pair
{
    int32 proxyIdA; ///< the smaller number
    int32 proxyIdB; ///< the larger number
};

/// Finds the pairs of proxies that may touch, looking only at those that moved. It does not
/// remember pairs: whoever is told of one keeps it until the boxes no longer overlap. That of a
/// world (b2ContactManager::m_broadPhase) is there to be read: the user data of its proxies are
/// b2FixtureProxy objects, whose proxyId is the number.
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
    const b2AABB& GetFatAABB(int32 proxyId) const
    {
        return TreeOf(proxyId).GetFatAABB(NodeOf(proxyId));
    }
    /// What CreateProxy was given.
    void* GetUserData(int32 proxyId) const { return TreeOf(proxyId).GetUserData(NodeOf(proxyId)); }

    /// Do the stored boxes overlap?
    bool TestOverlap(int32 proxyIdA, int32 proxyIdB) const
    {
        return b2TestOverlap(GetFatAABB(proxyIdA), GetFatAABB(proxyIdB));
    }

    int32 GetProxyCount() const; ///< how many proxies there are

    /// Calls `void callback->AddPair(void* userDataA, void* userDataB)` once for every pair that
    /// has a proxy which moved since the last time, in the order of their numbers.
    template <typename T>
    void UpdatePairs(T* callback);

    /// As in b2DynamicTree.
    template <typename T>
    void Query(T* callback, const b2AABB& aabb) const;
    /// As in b2DynamicTree.
    template <typename T>
    void RayCast(T* callback, const b2RayCastInput& input) const;

    int32 GetTreeHeight() const;    ///< of the highest tree; 0: one proxy or none
    int32 GetTreeBalance() const;   ///< as b2DynamicTree::GetMaxBalance, of the worst tree
    float32 GetTreeQuality() const; ///< as b2DynamicTree::GetAreaRatio, of the worst tree

    /// What was at newOrigin [m] is at zero.
    void ShiftOrigin(const b2Vec2& newOrigin) { m_tree.ShiftOrigin(newOrigin); }

private:
    friend class box2d::World;
    /// Looks at the trees of a world, which outlive it: a number has that of the tree in its lowest
    /// bits.
    b2BroadPhase(const b2DynamicTree* trees, int32 treeCount, int32 treeBits)
        : m_trees(trees), m_treeCount(treeCount), m_treeBits(treeBits)
    {}

    const b2DynamicTree& TreeOf(int32 proxyId) const
    {
        const int32 tree = proxyId & ((1 << m_treeBits) - 1);
        b2Assert(tree < m_treeCount);
        return m_trees[tree];
    }
    int32 NodeOf(int32 proxyId) const { return proxyId >> m_treeBits; }
    int32 NumberOf(int32 node, int32 tree) const { return (node << m_treeBits) | tree; }
    template <typename T>
    struct RayVisitor;

    /// Fills m_pairs, sorted and without repetition, and forgets what moved.
    void CollectPairs();

    b2DynamicTree m_tree;                   ///< its own; empty when it looks at others
    const b2DynamicTree* m_trees = &m_tree; ///< all that it looks at
    int32 m_treeCount = 1;
    int32 m_treeBits = 0;
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

template <typename T>
void b2BroadPhase::Query(T* callback, const b2AABB& aabb) const
{
    bool goesOn = true;
    for (int32 tree = 0; tree < m_treeCount && goesOn; ++tree)
    {
        m_trees[tree].ForEachOverlap(aabb, [&](int32 node) {
            goesOn = callback->QueryCallback(NumberOf(node, tree));
            return goesOn;
        });
    }
}

/// A ray through one tree; what is left of it goes through the next.
template <typename T>
struct b2BroadPhase::RayVisitor
{
    const b2BroadPhase& broadPhase;
    T* callback;
    int32 tree;
    float32 maxFraction;

    float32 RayCastCallback(const b2RayCastInput& input, int32 node)
    {
        const float32 value = callback->RayCastCallback(input, broadPhase.NumberOf(node, tree));
        maxFraction = value >= 0.0f ? value : maxFraction;
        return value;
    }
};

template <typename T>
void b2BroadPhase::RayCast(T* callback, const b2RayCastInput& input) const
{
    b2RayCastInput rest = input;
    for (int32 tree = 0; tree < m_treeCount; ++tree)
    {
        RayVisitor<T> visitor{*this, callback, tree, rest.maxFraction};
        m_trees[tree].RayCast(&visitor, rest);
        rest.maxFraction = visitor.maxFraction;
        if (rest.maxFraction == 0.0f)
        {
            return;
        }
    }
}
