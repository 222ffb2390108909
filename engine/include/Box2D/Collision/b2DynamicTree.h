// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Internal/BoxQuery.h>
#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Common/Array.h>
#include <Box2D/Common/b2GrowableStack.h>

/// @file
/// The bounding volume tree for overlap queries and ray casts.

/// The number that is not a proxy.
inline constexpr int32 b2_nullNode = -1;

namespace box2d
{
struct SnapshotAccess;
} // namespace box2d

/// A binary tree of axis-aligned boxes for overlap queries and ray casts. Leaves are the user's
/// proxies; their numbers stay valid until they are destroyed. The broad phase uses it, and a
/// program may use it for other objects that have a box.
/// Insertion follows the surface area heuristic and rotations keep the tree low, so the order of
/// insertion matters little. The result depends only on the sequence of calls. A callback may not
/// change the tree.
class b2DynamicTree
{
public:
    b2DynamicTree() = default;
    ~b2DynamicTree();
    b2DynamicTree(const b2DynamicTree&) = delete;
    b2DynamicTree& operator=(const b2DynamicTree&) = delete;

    /// Adds a proxy with the given box [m], enlarged by b2_aabbExtension on every side, and returns
    /// its number. A box that is not valid asserts.
    int32 CreateProxy(const b2AABB& aabb, void* userData);

    /// Removes a proxy; its number may be used again. Here and in the functions that move proxies,
    /// a number that is not a proxy asserts and changes nothing.
    void DestroyProxy(int32 proxyId);

    /// Moves a proxy. Returns false while its box stays inside the stored one. Otherwise returns
    /// true and stores a new box, enlarged and extended along the displacement [m].
    bool MoveProxy(int32 proxyId, const b2AABB& aabb, const b2Vec2& displacement);

    /// Same as CreateProxy, but stores the box unchanged, for callers with their own margin. User
    /// data is a pointer or a number, at the caller's choice.
    int32 CreateProxyExact(const b2AABB& fatAABB, void* userData);
    /// Same as above, with a number.
    int32 CreateProxyExact(const b2AABB& fatAABB, int32 userIndex);
    /// Stores the box unchanged and moves the proxy to its best place in the tree.
    void SetProxyAABB(int32 proxyId, const b2AABB& fatAABB);
    /// Keeps the proxy's place in the tree and enlarges the boxes above it. This is cheaper, but
    /// each call lowers the tree's quality until SetProxyAABB or RebuildBottomUp restores it. The
    /// box must contain the stored one; otherwise it asserts and changes nothing.
    void EnlargeProxy(int32 proxyId, const b2AABB& fatAABB);

    /// Returns the pointer given to CreateProxy. In these three functions the number must be a
    /// proxy's.
    void* GetUserData(int32 proxyId) const { return GetLeaf(proxyId).link.userData; }
    /// Returns the number given to CreateProxyExact.
    int32 GetUserIndex(int32 proxyId) const { return GetLeaf(proxyId).link.userIndex; }
    /// Returns the stored box [m].
    const b2AABB& GetFatAABB(int32 proxyId) const { return GetLeaf(proxyId).aabb; }

    /// True if this is the number of a proxy that was created and not destroyed.
    bool IsProxy(int32 proxyId) const
    {
        return 0 <= proxyId && proxyId < m_nodeCapacity && m_nodes[proxyId].height == 0;
    }

    int32 GetProxyCount() const { return m_proxyCount; } ///< number of proxies

    /// Calls `bool callback->QueryCallback(int32 proxyId)` for every proxy whose box overlaps the
    /// given one, until it returns false.
    template <typename T>
    void Query(T* callback, const b2AABB& aabb) const;

    /// Same as above, with any callable: `bool visit(int32 proxyId)`.
    template <typename Visit>
    void ForEachOverlap(const b2AABB& aabb, Visit&& visit) const;

    /// Calls `void visit(int32 proxyA, int32 proxyB)` once for every two proxies whose boxes
    /// overlap. Much faster than a query for every proxy.
    template <typename Visit>
    void ForEachPair(Visit&& visit) const;

    /// Calls `float32 callback->RayCastCallback(const b2RayCastInput& input, int32 proxyId)` for
    /// the proxies whose boxes the ray meets, approximately from near to far. The return value
    /// becomes the ray's maxFraction: 0 ends the cast, a negative number changes nothing.
    template <typename T>
    void RayCast(T* callback, const b2RayCastInput& input) const;

    /// Asserts that the structure is valid.
    void Validate() const;

    /// Returns the first defect of the structure, as a sentence; null if it is valid.
    const char* WhyInvalid() const;

    /// Returns the height; 0 for a tree with at most one proxy.
    int32 GetHeight() const;

    /// Returns the maximum height difference between two siblings, >= 0.
    int32 GetMaxBalance() const;

    /// Returns the perimeters of all nodes over that of the root, 0 without proxies: the average
    /// cost of a query.
    float32 GetAreaRatio() const;

    /// Builds the tree again from all its leaves, with better quality than insertion. Takes O(n
    /// log^2 n).
    void RebuildBottomUp();

    /// Same as RebuildBottomUp, but much faster, for a tree whose leaves move all the time. Every
    /// node splits its leaves into two equal halves, along the axis in which their centres spread
    /// more. A query visits more nodes than after RebuildBottomUp. Takes O(n log n), and allocates
    /// memory the first time only.
    void RebuildEvenly();
    /// Recomputes the boxes above all leaves without changing the structure of the tree.
    void RefitAll();
    /// Sets the box of a proxy without changing the boxes above it. Until one of the three
    /// functions above is called, only this function may be used.
    void SetProxyAABBForRebuild(int32 proxyId, const b2AABB& fatAABB);

    /// Subtracts the new origin [m], given in old coordinates, from every box.
    void ShiftOrigin(const b2Vec2& newOrigin);

private:
    friend struct box2d::SnapshotAccess;
    class Segment;

    // 32 bytes, so that two fit in a cache line.
    struct Node
    {
        union Link {
            int32 child[2];
            void* userData;
            int32 userIndex;
        };

        bool IsLeaf() const { return height == 0; }

        b2AABB aabb;
        Link link;
        int32 parent; ///< in a free node: the next free node
        int32 height; ///< leaves 0, free nodes -1
    };

    const Node& GetLeaf(int32 proxyId) const
    {
        b2Assert(IsProxy(proxyId));
        return m_nodes[proxyId];
    }

    struct CenteredLeaf
    {
        b2Vec2 twiceCenter;
        int32 id;
    };

    int32 AllocateNode();
    void FreeNode(int32 node);
    int32 AllocateLeaf(const b2AABB& aabb);
    void InsertLeaf(int32 leaf);
    void RemoveLeaf(int32 leaf);
    int32 FindSibling(const b2AABB& aabb) const;
    void ReplaceChild(int32 parent, int32 oldChild, int32 newChild);
    void RepairFrom(int32 node);
    void Refit(int32 node);
    void Rotate(int32 node);
    void SwapWithNephew(int32 node, int32 side, int32 nephewSide);
    int32 BalanceLimit() const;
    const char* WhyInvalid(int32 node, int32 parent, int32* proxies) const;
    void FreeInnerNodes();
    int32 BuildEvenly(int32 first, int32 count);
    void RefitFrom(int32 node);

    Node* m_nodes = nullptr;
    int32 m_root = b2_nullNode;
    int32 m_nodeCapacity = 0;
    int32 m_nodeCount = 0;
    int32 m_proxyCount = 0;
    int32 m_freeList = b2_nullNode;
    // Room for RebuildEvenly: all leaves, and their indices in the lower halves of numbers that are
    // in the leaves' order along an axis.
    box2d::Array<CenteredLeaf> m_leaves;
    box2d::Array<std::uint64_t> m_order;
};

template <typename T>
void b2DynamicTree::Query(T* callback, const b2AABB& aabb) const
{
    ForEachOverlap(aabb, [callback](int32 proxyId) { return callback->QueryCallback(proxyId); });
}

template <typename Visit>
void b2DynamicTree::ForEachOverlap(const b2AABB& aabb, Visit&& visit) const
{
    const box2d::BoxQuery query(aabb);
    if (m_root == b2_nullNode || !query.Overlaps(m_nodes[m_root].aabb))
    {
        return;
    }
    // Invariant: the boxes on the stack overlap the query.
    b2GrowableStack<int32, 256> stack;
    int32 id = m_root;
    while (true)
    {
        const Node& node = m_nodes[id];
        if (node.IsLeaf())
        {
            if (!visit(id))
            {
                return;
            }
        }
        else
        {
            const int32 first = node.link.child[0];
            const int32 second = node.link.child[1];
            const bool isFirst = query.Overlaps(m_nodes[first].aabb);
            if (query.Overlaps(m_nodes[second].aabb))
            {
                if (isFirst)
                {
                    stack.Push(first);
                }
                id = second;
                continue;
            }
            if (isFirst)
            {
                id = first;
                continue;
            }
        }
        if (stack.GetCount() == 0)
        {
            return;
        }
        id = stack.Pop();
    }
}

template <typename Visit>
void b2DynamicTree::ForEachPair(Visit&& visit) const
{
    struct Two
    {
        int32 a, b; ///< a == b: all pairs below it; otherwise the boxes overlap
    };
    if (m_root == b2_nullNode)
    {
        return;
    }
    b2GrowableStack<Two, 256> stack;
    stack.Push({m_root, m_root});
    while (stack.GetCount() > 0)
    {
        const Two two = stack.Pop();
        const Node& a = m_nodes[two.a];
        const Node& b = m_nodes[two.b];
        if (two.a == two.b)
        {
            if (!a.IsLeaf())
            {
                const int32* child = a.link.child;
                stack.Push({child[0], child[0]});
                stack.Push({child[1], child[1]});
                stack.PushIf(b2TestOverlap(m_nodes[child[0]].aabb, m_nodes[child[1]].aabb),
                             {child[0], child[1]});
            }
        }
        else if (a.IsLeaf() && b.IsLeaf())
        {
            visit(two.a, two.b);
        }
        else
        {
            const bool partsA = a.height >= b.height;
            const int32 whole = partsA ? two.b : two.a;
            const b2AABB& box = m_nodes[whole].aabb;
            for (const int32 child : (partsA ? a : b).link.child)
            {
                stack.PushIf(b2TestOverlap(m_nodes[child].aabb, box), {child, whole});
            }
        }
    }
}

/// The ray as a segment that can become shorter during a cast.
class b2DynamicTree::Segment
{
public:
    explicit Segment(const b2RayCastInput& input)
        : m_p1(input.p1), m_d(input.p2 - input.p1), m_across(m_d.Skew()),
          m_absAcross(b2Abs(m_across)), m_twiceP1(2.0f * input.p1)
    {
        CutAt(input.maxFraction);
    }

    void CutAt(float32 fraction)
    {
        const b2Vec2 end = m_p1 + fraction * m_d;
        m_lower = b2Min(m_p1, end);
        m_upper = b2Max(m_p1, end);
    }

    /// Separating axis test with three directions: the two axes and the segment's normal. All three
    /// are evaluated: which one separates is unpredictable, and a mispredicted branch costs more.
    bool Meets(const b2AABB& box) const
    {
        // Twice the distance of the centre and twice the box's extent along the segment's normal.
        const b2Vec2 fromCenter = m_twiceP1 - (box.lowerBound + box.upperBound);
        const float32 offset = b2Dot(m_across, fromCenter);
        const float32 reach = b2Dot(m_absAcross, box.upperBound - box.lowerBound);
        return (box.lowerBound.x <= m_upper.x) & (m_lower.x <= box.upperBound.x) &
               (box.lowerBound.y <= m_upper.y) & (m_lower.y <= box.upperBound.y) &
               !(b2Abs(offset) > reach);
    }

    /// True if the centre of b lies before that of a along the ray.
    bool IsBefore(const b2AABB& b, const b2AABB& a) const
    {
        const b2Vec2 fromAToB = (b.lowerBound + b.upperBound) - (a.lowerBound + a.upperBound);
        return b2Dot(fromAToB, m_d) < 0.0f;
    }

private:
    b2Vec2 m_p1;
    b2Vec2 m_d;
    b2Vec2 m_across;
    b2Vec2 m_absAcross;
    b2Vec2 m_twiceP1;
    b2Vec2 m_lower; ///< bounding box of the remaining segment
    b2Vec2 m_upper;
};

template <typename T>
void b2DynamicTree::RayCast(T* callback, const b2RayCastInput& input) const
{
    Segment segment(input);
    if (m_root == b2_nullNode || !segment.Meets(m_nodes[m_root].aabb))
    {
        return;
    }
    b2RayCastInput subInput = input;
    b2GrowableStack<int32, 256> stack;
    int32 id = m_root;
    while (true)
    {
        const Node& node = m_nodes[id];
        if (node.IsLeaf())
        {
            const float32 value = callback->RayCastCallback(subInput, id);
            if (value == 0.0f)
            {
                return;
            }
            if (value > 0.0f)
            {
                subInput.maxFraction = value;
                segment.CutAt(value);
            }
        }
        else
        {
            const int32* child = node.link.child;
            const b2AABB& first = m_nodes[child[0]].aabb;
            const b2AABB& second = m_nodes[child[1]].aabb;
            const bool isFirst = segment.Meets(first);
            const bool isSecond = segment.Meets(second);
            if (isFirst && isSecond)
            {
                // Visit the nearer child first: a hit there may make the other unnecessary.
                const int32 nearer = segment.IsBefore(second, first) ? 1 : 0;
                stack.Push(child[1 - nearer]);
                id = child[nearer];
                continue;
            }
            if (isFirst || isSecond)
            {
                id = child[isFirst ? 0 : 1];
                continue;
            }
        }
        do
        {
            if (stack.GetCount() == 0)
            {
                return;
            }
            id = stack.Pop();
        } while (!segment.Meets(m_nodes[id].aabb)); // the ray may have become shorter since the
                                                    // push
    }
}
