// SPDX-License-Identifier: MIT
#pragma once

#include "Archive.h"
#include "SnapshotAccess.h"

#include "../State/Proxies.h"

/// The exact trees. Their structure determines the order of pairs, and the order of their free
/// nodes the numbers of new proxies.
namespace box2d
{

/// A tree does not know the owners of its leaves. The fixtures do.
template <class Archive>
void SnapshotAccess::Visit(Archive& archive, b2DynamicTree& tree)
{
    auto& [nodes, root, capacity, nodeCount, proxyCount, freeList, leaves, order] = tree;
    typedef b2DynamicTree::Node Node;
    constexpr std::size_t minBytes = 2 * sizeof(int32); // size of a free node
    archive.Count(capacity, minBytes);
    if constexpr (Archive::kReads)
    {
        nodes =
            capacity > 0 ? static_cast<Node*>(b2Alloc(capacity * int32(sizeof(Node)))) : nullptr;
    }
    archive.Within(root, b2_nullNode, capacity - 1);
    archive.Within(freeList, b2_nullNode, capacity - 1);
    archive(nodeCount, proxyCount);
    for (int32 i = 0; i < capacity; ++i)
    {
        Node& node = nodes[i];
        if constexpr (Archive::kReads)
        {
            node = Node();
        }
        archive.Within(node.height, -1, capacity);
        archive.Within(node.parent, b2_nullNode, capacity - 1);
        if (node.height >= 0)
        {
            archive(node.aabb);
        }
        if (node.height > 0)
        {
            archive.Within(node.link.child[0], 0, capacity - 1);
            archive.Within(node.link.child[1], 0, capacity - 1);
        }
    }
    if constexpr (Archive::kReads)
    {
        archive.Require(IsSound(tree));
    }
}

/// Checks that every traversal of the tree stays in range and terminates.
inline bool SnapshotAccess::IsSound(const b2DynamicTree& tree)
{
    for (int32 i = 0; i < tree.m_nodeCapacity; ++i)
    {
        const b2DynamicTree::Node& node = tree.m_nodes[i];
        if (node.height > 0)
        {
            const auto [a, b] = node.link.child;
            if (a == b || tree.m_nodes[a].parent != i || tree.m_nodes[b].parent != i ||
                tree.m_nodes[a].height < 0 || tree.m_nodes[b].height < 0)
            {
                return false;
            }
        }
    }
    int32 free = 0;
    for (int32 i = tree.m_freeList; i != b2_nullNode; i = tree.m_nodes[i].parent)
    {
        if (tree.m_nodes[i].height != -1 || ++free > tree.m_nodeCapacity)
        {
            return false;
        }
    }
    return tree.WhyInvalid() == nullptr;
}

template <class Archive>
void SnapshotAccess::Visit(Archive& archive, Proxies& proxies)
{
    // `rebuilds` is true only within a step; `found` is scratch.
    auto& [trees, marks, categories, categoryCounts, present, moved, found, count, staticAdded,
           rebuilds, refits, rebuilt] = proxies;
    for (int32 i = 0; i < Proxies::kTreeCount; ++i)
    {
        Visit(archive, trees[i]);
        archive(marks[i], categories[i]);
        archive.Require(marks[i].size() == categories[i].size() &&
                        marks[i].size() <= std::size_t(trees[i].m_nodeCapacity));
    }
    archive(categoryCounts, present, moved, count, staticAdded, refits, rebuilt);
    for (const int32 id : moved)
    {
        archive.Require((id & 3) < Proxies::kTreeCount && id >= 0 &&
                        std::size_t(id >> 2) < marks[id & 3].size());
        if (!archive.IsSound())
        {
            return;
        }
    }
}

inline bool SnapshotAccess::IsProxy(const Proxies& proxies, int32 proxyId)
{
    const int32 tree = proxyId & 3;
    return proxyId >= 0 && tree < Proxies::kTreeCount &&
           proxies.m_trees[tree].IsProxy(proxyId >> 2) &&
           std::size_t(proxyId >> 2) < proxies.m_marks[tree].size();
}

inline bool SnapshotAccess::Connect(Proxies& proxies, b2FixtureProxy& proxy)
{
    if (!IsProxy(proxies, proxy.proxyId) || proxies.Get(proxy.proxyId) != nullptr)
    {
        return false;
    }
    b2DynamicTree& tree = proxies.m_trees[proxy.proxyId & 3];
    tree.m_nodes[proxy.proxyId >> 2].link.userData = &proxy;
    return true;
}

inline bool SnapshotAccess::AreAllConnected(const Proxies& proxies)
{
    int32 count = 0;
    for (const b2DynamicTree& tree : proxies.m_trees)
    {
        for (int32 i = 0; i < tree.m_nodeCapacity; ++i)
        {
            if (tree.IsProxy(i) && tree.GetUserData(i) == nullptr)
            {
                return false;
            }
        }
        count += tree.GetProxyCount();
    }
    return count == proxies.m_count;
}

} // namespace box2d
