// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Common/Array.h>
#include <Box2D/Common/b2GrowableStack.h>

/// @file
/// The tree of boxes that finds what overlaps and what a ray meets.

/// No proxy of a tree.
inline constexpr int32 b2_nullNode = -1;

namespace box2d
{
struct SnapshotAccess;
} // namespace box2d

/// A binary tree of axis-aligned boxes that finds what overlaps a box or meets a ray. Leaves are
/// the user's proxies, known by a number that stays valid until they are destroyed. The broad phase
/// is built on it, and a program may use it for anything else that has a box. Insertion follows the
/// surface area heuristic and rotations keep the tree low, so the order of insertion matters
/// little; the result depends on nothing but the sequence of calls. A callback may not change the
/// tree.
class b2DynamicTree
{
public:
    b2DynamicTree() = default;
    ~b2DynamicTree();
    b2DynamicTree(const b2DynamicTree&) = delete;
    b2DynamicTree& operator=(const b2DynamicTree&) = delete;

    /// Adds a proxy whose box is the given one [m], made b2_aabbExtension larger on every side.
    /// Returns its number. A box that is not valid asserts.
    int32 CreateProxy(const b2AABB& aabb, void* userData);

    /// Removes a proxy; its number may be given to another. A number of no proxy asserts and
    /// changes nothing, here and in all that move one.
    void DestroyProxy(int32 proxyId);

    /// Follows a proxy that moves: while its box stays inside the stored one nothing happens and
    /// the answer is false; else the stored box is made anew, larger and ahead of the displacement
    /// [m].
    bool MoveProxy(int32 proxyId, const b2AABB& aabb, const b2Vec2& displacement);

    /// The same three steps for callers with a margin of their own: the box is stored as it is.
    /// User data is a pointer or a number, at the caller's choice.
    int32 CreateProxyExact(const b2AABB& fatAABB, void* userData);
    /// The same with a number.
    int32 CreateProxyExact(const b2AABB& fatAABB, int32 userIndex);
    /// Moves the proxy to where its box belongs in the tree.
    void SetProxyAABB(int32 proxyId, const b2AABB& fatAABB);
    /// Leaves the proxy where it is in the tree and lets the boxes above it grow: cheaper, but the
    /// tree gets worse with every call until SetProxyAABB or RebuildBottomUp puts it right. The
    /// box must contain the stored one, else it asserts and nothing changes.
    void EnlargeProxy(int32 proxyId, const b2AABB& fatAABB);

    /// What CreateProxy was given. The number must be a proxy's, in these three.
    void* GetUserData(int32 proxyId) const { return GetLeaf(proxyId).link.userData; }
    /// What CreateProxyExact was given.
    int32 GetUserIndex(int32 proxyId) const { return GetLeaf(proxyId).link.userIndex; }
    /// The stored box [m].
    const b2AABB& GetFatAABB(int32 proxyId) const { return GetLeaf(proxyId).aabb; }

    /// Is this the number of a proxy that has been created and not destroyed?
    bool IsProxy(int32 proxyId) const
    {
        return 0 <= proxyId && proxyId < m_nodeCapacity && m_nodes[proxyId].height == 0;
    }

    int32 GetProxyCount() const { return m_proxyCount; } ///< how many proxies there are

    /// Calls `bool callback->QueryCallback(int32 proxyId)` for every proxy whose box overlaps the
    /// given one, until it returns false.
    template <typename T>
    void Query(T* callback, const b2AABB& aabb) const;

    /// The same with any callable: `bool visit(int32 proxyId)`.
    template <typename Visit>
    void ForEachOverlap(const b2AABB& aabb, Visit&& visit) const;

    /// Calls `void visit(int32 proxyA, int32 proxyB)` for every two proxies whose boxes overlap,
    /// once each: a fraction of the time that a query for every proxy takes.
    template <typename Visit>
    void ForEachPair(Visit&& visit) const;

    /// Calls `float32 callback->RayCastCallback(const b2RayCastInput& input, int32 proxyId)` for
    /// the proxies whose boxes the ray meets, roughly in its direction. What it returns is the
    /// ray's maxFraction from there on: 0 ends the cast, a negative number changes nothing.
    template <typename T>
    void RayCast(T* callback, const b2RayCastInput& input) const;

    /// Checks the whole structure, with asserts on.
    void Validate() const;

    /// What is wrong with the structure, as a sentence; null when nothing is.
    const char* WhyInvalid() const;

    /// 0 for a tree of one proxy or none.
    int32 GetHeight() const;

    /// The largest difference of height between two siblings, 0 or more.
    int32 GetMaxBalance() const;

    /// The perimeters of all nodes over that of the root, 0 without proxies: what a query pays on
    /// average.
    float32 GetAreaRatio() const;

    /// Builds the tree anew from all its leaves, better than insertion does. Takes O(n log^2 n).
    void RebuildBottomUp();

    /// The same in a small part of the time, for a tree whose leaves move all the time: every node
    /// parts its leaves in two equal halves, along the axis in which their centres spread more. A
    /// query looks at more nodes than after RebuildBottomUp. Takes O(n log n), and memory the first
    /// time only.
    void RebuildEvenly();
    /// Makes the boxes above all leaves anew and leaves the form of the tree as it is.
    void RefitAll();
    /// Gives a proxy another box and leaves the boxes above it as they are: until one of these
    /// three has been called the tree is good for nothing but more of the same.
    void SetProxyAABBForRebuild(int32 proxyId, const b2AABB& fatAABB);

    /// Subtracts the new origin [m], given in old coordinates, from every box.
    void ShiftOrigin(const b2Vec2& newOrigin);

private:
    friend struct box2d::SnapshotAccess;
    class Segment;

    // 32 bytes, two to a cache line.
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
        int32 parent; ///< of a free node: the next free one
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
    box2d::Array<CenteredLeaf> m_order; ///< room for RebuildEvenly
};

template <typename T>
void b2DynamicTree::Query(T* callback, const b2AABB& aabb) const
{
    ForEachOverlap(aabb, [callback](int32 proxyId) { return callback->QueryCallback(proxyId); });
}

template <typename Visit>
void b2DynamicTree::ForEachOverlap(const b2AABB& aabb, Visit&& visit) const
{
    if (m_root == b2_nullNode || !b2TestOverlap(m_nodes[m_root].aabb, aabb))
    {
        return;
    }
    // What waits on the stack overlaps.
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
            const bool isFirst = b2TestOverlap(m_nodes[first].aabb, aabb);
            if (b2TestOverlap(m_nodes[second].aabb, aabb))
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
        int32 a, b; ///< the same: all pairs below it; else they overlap
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

/// What a ray is to the boxes of a tree: a segment that may become shorter.
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

    /// A segment misses a box when one of three directions separates them: the two axes, and the
    /// one across the segment. All are looked at, for which of them does it is hard to foresee and
    /// a branch would cost more.
    bool Meets(const b2AABB& box) const
    {
        // Twice the distance of the centre and twice the reach of the box across the segment.
        const b2Vec2 fromCenter = m_twiceP1 - (box.lowerBound + box.upperBound);
        const float32 offset = b2Dot(m_across, fromCenter);
        const float32 reach = b2Dot(m_absAcross, box.upperBound - box.lowerBound);
        return (box.lowerBound.x <= m_upper.x) & (m_lower.x <= box.upperBound.x) &
               (box.lowerBound.y <= m_upper.y) & (m_lower.y <= box.upperBound.y) &
               !(b2Abs(offset) > reach);
    }

    /// Whether b lies before a along the ray, by their centres.
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
    b2Vec2 m_lower; ///< the corners of the box around what is left of the segment
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
                // What is further along the ray waits, since a hit may make it needless.
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
        } while (!segment.Meets(m_nodes[id].aabb)); // the ray may have become shorter
    }
}
