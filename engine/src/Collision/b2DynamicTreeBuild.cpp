// SPDX-License-Identifier: MIT
//
// Builds the tree again, from the top. Each node splits its leaves along an axis. The split
// minimizes the sum of the perimeters of both parts, each times its number of leaves (Wald 2007 for
// full builds). The leaves are sorted along both axes once. A split keeps both orders (Wald and
// Havran 2006), so a level of the tree costs one pass and no sorting.
#include <Box2D/Collision/b2DynamicTree.h>

#include <Box2D/Common/Array.h>

#include <algorithm>
#include <bit>
#include <span>

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

// The order of the leaves along one axis; a subtree has the same range in both orders.
typedef box2d::Array<int32> Order;

float32 TwiceCenter(const Leaf& leaf, int32 axis)
{
    return leaf.aabb.lowerBound(axis) + leaf.aabb.upperBound(axis);
}

struct Range
{
    int32 first;
    int32 count;
    int32 parent;
    int32 side;
    int32 depth;
};

// Splits ranges of leaves; independent of the tree's nodes.
class Divider
{
public:
    explicit Divider(box2d::Array<Leaf> leaves)
        : m_leaves(std::move(leaves)), m_costs(m_leaves.size()), m_isInFirst(m_leaves.size()),
          m_second(m_leaves.size())
    {
        for (int32 axis = 0; axis < 2; ++axis)
        {
            for (std::size_t i = 0; i < m_leaves.size(); ++i)
            {
                m_orders[axis].push_back(static_cast<int32>(i));
            }
            // Equal centres are ordered by number, so that the order is unique.
            std::sort(m_orders[axis].begin(), m_orders[axis].end(), [&](int32 a, int32 b) {
                const float32 centerA = TwiceCenter(m_leaves[std::size_t(a)], axis);
                const float32 centerB = TwiceCenter(m_leaves[std::size_t(b)], axis);
                return centerA != centerB ? centerA < centerB : a < b;
            });
        }
    }

    int32 IdOfFirst(const Range& range) const { return At(0, range.first).id; }

    /// Returns the number of leaves in the first part, which is moved to the front in both orders.
    int32 Divide(const Range& range, bool isEven)
    {
        const int32 axis = AxisOfSpread(range);
        const int32 split = isEven ? range.count / 2 : FindSplit(range, axis);
        const Order& order = m_orders[axis];
        for (int32 i = 0; i < range.count; ++i)
        {
            m_isInFirst[std::size_t(order[std::size_t(range.first + i)])] = i < split;
        }
        Part(range, m_orders[1 - axis]);
        return split;
    }

private:
    const Leaf& At(int32 axis, int32 place) const
    {
        return m_leaves[std::size_t(m_orders[axis][std::size_t(place)])];
    }

    /// Returns the axis with the larger spread of centres.
    int32 AxisOfSpread(const Range& range) const
    {
        const int32 last = range.first + range.count - 1;
        const float32 x = TwiceCenter(At(0, last), 0) - TwiceCenter(At(0, range.first), 0);
        const float32 y = TwiceCenter(At(1, last), 1) - TwiceCenter(At(1, range.first), 1);
        return x >= y ? 0 : 1;
    }

    int32 FindSplit(const Range& range, int32 axis)
    {
        b2AABB box = At(axis, range.first + range.count - 1).aabb;
        for (int32 i = range.count - 1; i > 0; --i)
        {
            box.Combine(At(axis, range.first + i).aabb);
            m_costs[std::size_t(i)] = HalfPerimeter(box) * static_cast<float32>(range.count - i);
        }
        int32 best = range.count / 2;
        float32 bestCost = b2_maxFloat;
        box = At(axis, range.first).aabb;
        for (int32 i = 1; i < range.count; ++i)
        {
            const float32 cost =
                HalfPerimeter(box) * static_cast<float32>(i) + m_costs[std::size_t(i)];
            const bool isMoreEven = b2Abs(2 * i - range.count) < b2Abs(2 * best - range.count);
            if (cost < bestCost || (cost == bestCost && isMoreEven))
            {
                bestCost = cost;
                best = i;
            }
            box.Combine(At(axis, range.first + i).aabb);
        }
        return best;
    }

    /// Moves the first part to the front; a stable partition.
    void Part(const Range& range, Order& order)
    {
        const auto begin = order.begin() + range.first;
        auto front = begin;
        auto back = m_second.begin();
        for (auto i = begin; i != begin + range.count; ++i)
        {
            *(m_isInFirst[std::size_t(*i)] ? front++ : back++) = *i;
        }
        std::copy(m_second.begin(), back, front);
    }

    box2d::Array<Leaf> m_leaves; // by number
    Order m_orders[2];           // indices into m_leaves
    box2d::Array<float32> m_costs;
    box2d::Array<uint8> m_isInFirst; // by index in m_leaves
    Order m_second;                  // scratch for the second part
};
} // namespace

void b2DynamicTree::FreeInnerNodes()
{
    for (int32 i = 0; i < m_nodeCapacity; ++i)
    {
        if (m_nodes[i].height > 0)
        {
            FreeNode(i);
        }
    }
}

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
    }
    FreeInnerNodes();

    // Nodes are created before their children, so heights are set in reverse order.
    Divider divider(std::move(leaves));
    box2d::Array<int32> made;
    b2GrowableStack<Range, 256> stack;
    stack.Push({0, m_proxyCount, b2_nullNode, 0, 0});
    while (stack.GetCount() > 0)
    {
        const Range range = stack.Pop();
        const int32 node = range.count == 1 ? divider.IdOfFirst(range) : AllocateNode();
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
        // Beyond this depth the heuristic removes one leaf after another.
        const int32 split = divider.Divide(range, range.depth >= BalanceLimit());
        stack.Push({range.first, split, node, 0, range.depth + 1});
        stack.Push({range.first + split, range.count - split, node, 1, range.depth + 1});
    }
    for (std::size_t i = made.size(); i > 0; --i)
    {
        Refit(made[i - 1]);
    }
}

namespace
{
/// Returns bits in the order of the numbers. Equal ones are equal, so that halves are unique.
uint32 InOrder(float32 number)
{
    constexpr uint32 sign = 0x80000000u;
    const auto bits = std::bit_cast<uint32>(number + 0.0f); // -0 becomes 0
    return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// Moves the last item to the place where it belongs, behind all that are less. Returns the place.
/// No branch depends on the items, because every second one would be mispredicted (Edelkamp and
/// Weiss, "BlockQuicksort", 2016; here Lomuto's scheme).
std::uint64_t* Part(std::uint64_t* begin, std::uint64_t* end)
{
    const std::uint64_t pivot = end[-1];
    std::uint64_t* place = begin;
    for (std::uint64_t* i = begin; i != end - 1; ++i)
    {
        const std::uint64_t item = *i;
        *i = *place;
        *place = item;
        place += item < pivot;
    }
    end[-1] = *place;
    *place = pivot;
    return place;
}

/// Exchanges items until all of the first half are less than those of the second (Hoare, "Find",
/// 1961).
void Halve(std::uint64_t* begin, int32 count)
{
    // Few items are left after that, unless pivots are far off.
    const int32 maxRounds = std::bit_width(static_cast<uint32>(count));
    std::uint64_t* const middle = begin + count / 2;
    std::uint64_t* end = begin + count;
    for (int32 round = 0; end - begin > 1; ++round)
    {
        if (round == maxRounds)
        {
            std::nth_element(begin, middle, end);
            return;
        }
        // The median of three becomes the last.
        std::uint64_t& first = *begin;
        std::uint64_t& half = begin[(end - begin) / 2];
        std::uint64_t& last = end[-1];
        const std::uint64_t median = b2Max(b2Min(first, half), b2Min(b2Max(first, half), last));
        std::swap(median == first ? first : median == half ? half : last, last);
        std::uint64_t* const place = Part(begin, end);
        if (place == middle)
        {
            return;
        }
        (place < middle ? begin : end) = place < middle ? place + 1 : place;
    }
}
} // namespace

void b2DynamicTree::SetProxyAABBForRebuild(int32 proxyId, const b2AABB& fatAABB)
{
    if (B2_REQUIRE(IsProxy(proxyId), "b2DynamicTree::SetProxyAABBForRebuild: not a proxy.") &&
        B2_REQUIRE(fatAABB.IsValid(),
                   "A proxy's box must be finite, its lower bound below the upper."))
    {
        m_nodes[proxyId].aabb = fatAABB;
    }
}

void b2DynamicTree::RefitAll()
{
    if (m_root != b2_nullNode)
    {
        RefitFrom(m_root);
    }
}

void b2DynamicTree::RefitFrom(int32 node)
{
    if (!m_nodes[node].IsLeaf())
    {
        RefitFrom(m_nodes[node].link.child[0]);
        RefitFrom(m_nodes[node].link.child[1]);
        Refit(node);
    }
}

void b2DynamicTree::RebuildEvenly()
{
    if (m_proxyCount < 2)
    {
        return;
    }
    m_leaves.clear();
    m_order.clear();
    for (int32 i = 0; i < m_nodeCapacity; ++i)
    {
        if (m_nodes[i].height == 0)
        {
            m_order.push_back(m_leaves.size());
            m_leaves.push_back({m_nodes[i].aabb.lowerBound + m_nodes[i].aabb.upperBound, i});
        }
    }
    FreeInnerNodes();
    m_root = BuildEvenly(0, m_proxyCount);
    m_nodes[m_root].parent = b2_nullNode;
}

/// Returns the node above a range of leaves. The recursion depth is the logarithm of their number.
int32 b2DynamicTree::BuildEvenly(int32 first, int32 count)
{
    const std::span<std::uint64_t> order(m_order.data() + first, std::size_t(count));
    const auto leafOf = [this](std::uint64_t item) -> const CenteredLeaf& {
        return m_leaves[uint32(item)];
    };
    if (count == 1)
    {
        return leafOf(order[0]).id;
    }
    b2Vec2 lower = leafOf(order[0]).twiceCenter;
    b2Vec2 upper = lower;
    for (const std::uint64_t item : order)
    {
        lower = b2Min(lower, leafOf(item).twiceCenter);
        upper = b2Max(upper, leafOf(item).twiceCenter);
    }
    const auto axis = upper.x - lower.x >= upper.y - lower.y ? &b2Vec2::x : &b2Vec2::y;
    for (std::uint64_t& item : order)
    {
        item = std::uint64_t(InOrder(leafOf(item).twiceCenter.*axis)) << 32 | uint32(item);
    }
    Halve(order.data(), count);
    const int32 node = AllocateNode();
    const int32 child[2] = {BuildEvenly(first, count / 2),
                            BuildEvenly(first + count / 2, count - count / 2)};
    for (int32 side = 0; side < 2; ++side)
    {
        m_nodes[node].link.child[side] = child[side];
        m_nodes[child[side]].parent = node;
    }
    Refit(node);
    return node;
}
