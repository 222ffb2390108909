// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Collision/b2DynamicTree.h>
#include <Box2D/Common/Array.h>

/// @file
/// Finds pairs of proxies whose boxes overlap.

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

/// Finds the pairs of proxies that may touch. Only proxies that moved are tested. Pairs are not
/// stored: the receiver of AddPair keeps each pair until the boxes no longer overlap.
/// The broad phase of a world (b2ContactManager::m_broadPhase) is read-only. The user data of its
/// proxies are b2FixtureProxy objects, whose proxyId is the proxy's number.
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

    /// Adds a proxy with this box [m] and returns its number. The next UpdatePairs reports its
    /// pairs. Boxes as in b2DynamicTree::CreateProxy.
    int32 CreateProxy(const b2AABB& aabb, void* userData);

    /// Removes a proxy. The caller removes its pairs. Here and below, a number that is not a proxy
    /// asserts and changes nothing.
    void DestroyProxy(int32 proxyId);

    /// Moves a proxy [m]. New pairs are possible when it has left its stored box.
    void MoveProxy(int32 proxyId, const b2AABB& aabb, const b2Vec2& displacement);

    /// Makes the next UpdatePairs report all pairs of this proxy again.
    void TouchProxy(int32 proxyId);

    /// Returns the stored box [m].
    const b2AABB& GetFatAABB(int32 proxyId) const
    {
        return TreeOf(proxyId).GetFatAABB(NodeOf(proxyId));
    }
    /// Returns the user data given to CreateProxy.
    void* GetUserData(int32 proxyId) const { return TreeOf(proxyId).GetUserData(NodeOf(proxyId)); }

    /// True if the stored boxes overlap.
    bool TestOverlap(int32 proxyIdA, int32 proxyIdB) const
    {
        return b2TestOverlap(GetFatAABB(proxyIdA), GetFatAABB(proxyIdB));
    }

    int32 GetProxyCount() const; ///< number of proxies

    /// Calls `void callback->AddPair(void* userDataA, void* userDataB)` once for every pair with a
    /// proxy that moved since the last call. Pairs are sorted by proxy number.
    template <typename T>
    void UpdatePairs(T* callback);

    /// Same as b2DynamicTree::Query.
    template <typename T>
    void Query(T* callback, const b2AABB& aabb) const;
    /// Same as b2DynamicTree::RayCast.
    template <typename T>
    void RayCast(T* callback, const b2RayCastInput& input) const;

    int32 GetTreeHeight() const;    ///< of the highest tree; 0 with at most one proxy
    int32 GetTreeBalance() const;   ///< as b2DynamicTree::GetMaxBalance, of the worst tree
    float32 GetTreeQuality() const; ///< as b2DynamicTree::GetAreaRatio, of the worst tree

    /// Subtracts newOrigin [m], given in old coordinates, from every box.
    void ShiftOrigin(const b2Vec2& newOrigin) { m_tree.ShiftOrigin(newOrigin); }

private:
    friend class box2d::World;
    /// Reads the trees of a world, which must outlive this object. The lowest bits of a proxy
    /// number are the index of its tree.
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

    /// Fills m_pairs, sorted and without duplicates, and clears the list of moved proxies.
    void CollectPairs();

    b2DynamicTree m_tree;                   ///< own tree; empty when it reads others
    const b2DynamicTree* m_trees = &m_tree; ///< the trees it reads
    int32 m_treeCount = 1;
    int32 m_treeBits = 0;
    box2d::Array<int32> m_moved; ///< may contain duplicates and destroyed proxies
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

/// Casts a ray through one tree; the remaining part goes through the next.
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
