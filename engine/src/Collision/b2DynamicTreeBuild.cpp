// SPDX-License-Identifier: MIT
//
// The tree built anew, from the top: at each node the leaves are sorted along an axis and parted
// where the perimeters of the two parts, each times its number of leaves, add up to the least
// (Wald 2007 for the heuristic's use in full builds).
#include <Box2D/Collision/b2DynamicTree.h>

#include <Box2D/Common/Array.h>

#include <algorithm>

namespace
{
struct Leaf
{
    b2AABB aabb;
    int32 id;
};

float32 HalfPerimeter(const b2AABB& box)
{
    return (box.upperBound.x - box.lowerBound.x) + (box.upperBound.y - box.lowerBound.y);
}

// By twice the centre; equal centres by number, so that the order is always the same.
void Sort(Leaf* leaves, int32 count, int32 axis)
{
    std::sort(leaves, leaves + count, [axis](const Leaf& a, const Leaf& b) {
        const float32 centerA = a.aabb.lowerBound(axis) + a.aabb.upperBound(axis);
        const float32 centerB = b.aabb.lowerBound(axis) + b.aabb.upperBound(axis);
        return centerA != centerB ? centerA < centerB : a.id < b.id;
    });
}

// Sorts along the axis in which the centres spread more.
void SortAlongSpread(Leaf* leaves, int32 count)
{
    b2Vec2 lower(b2_maxFloat, b2_maxFloat);
    b2Vec2 upper = -lower;
    for (int32 i = 0; i < count; ++i)
    {
        const b2Vec2 center = leaves[i].aabb.GetCenter();
        lower = b2Min(lower, center);
        upper = b2Max(upper, center);
    }
    Sort(leaves, count, upper.x - lower.x >= upper.y - lower.y ? 0 : 1);
}

// How many of the sorted leaves go to the first part; costs is room for as many numbers.
int32 FindSplit(const Leaf* leaves, int32 count, float32* costs)
{
    b2AABB box = leaves[count - 1].aabb;
    for (int32 i = count - 1; i > 0; --i)
    {
        box.Combine(leaves[i].aabb);
        costs[i] = HalfPerimeter(box) * static_cast<float32>(count - i);
    }
    int32 best = count / 2;
    float32 bestCost = b2_maxFloat;
    box = leaves[0].aabb;
    for (int32 i = 1; i < count; ++i)
    {
        const float32 cost = HalfPerimeter(box) * static_cast<float32>(i) + costs[i];
        const bool isMoreEven = b2Abs(2 * i - count) < b2Abs(2 * best - count);
        if (cost < bestCost || (cost == bestCost && isMoreEven))
        {
            bestCost = cost;
            best = i;
        }
        box.Combine(leaves[i].aabb);
    }
    return best;
}

struct Range
{
    int32 first;
    int32 count;
    int32 parent;
    int32 side;
    int32 depth;
};
} // namespace

void b2DynamicTree::RebuildBottomUp()
{
    if (m_proxyCount < 2)
    {
        return;
    }
    box2d::Array<Leaf> leaves;
    leaves.reserve(static_cast<std::size_t>(m_proxyCount));
    for (int32 i = 0; i < m_nodeCapacity; ++i)
    {
        if (m_nodes[i].height == 0)
        {
            leaves.push_back({m_nodes[i].aabb, i});
        }
        else if (m_nodes[i].height > 0)
        {
            FreeNode(i);
        }
    }

    // A node is made before its children, so the heights can be set from the last to the first.
    box2d::Array<float32> costs(leaves.size());
    box2d::Array<int32> made;
    b2GrowableStack<Range, 256> stack;
    stack.Push({0, m_proxyCount, b2_nullNode, 0, 0});
    while (stack.GetCount() > 0)
    {
        const Range range = stack.Pop();
        Leaf* first = leaves.data() + range.first;
        const int32 node = range.count == 1 ? first->id : AllocateNode();
        m_nodes[node].parent = range.parent;
        if (range.parent == b2_nullNode)
        {
            m_root = node;
        }
        else
        {
            m_nodes[range.parent].link.child[range.side] = node;
        }
        if (range.count == 1)
        {
            continue;
        }
        made.push_back(node);
        SortAlongSpread(first, range.count);
        // Deeper than this the heuristic peels off one leaf after another.
        const int32 split = range.depth < BalanceLimit()
                                ? FindSplit(first, range.count, costs.data())
                                : range.count / 2;
        stack.Push({range.first, split, node, 0, range.depth + 1});
        stack.Push({range.first + split, range.count - split, node, 1, range.depth + 1});
    }
    for (std::size_t i = made.size(); i > 0; --i)
    {
        Refit(made[i - 1]);
    }
}
