// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2DynamicTree.h>
#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

struct b2FixtureProxy;

/// The world's broad phase: a dynamic tree for each mobility, so that what never moves costs
/// nothing, and the list of proxies whose boxes have moved since pairs were last looked for. Knows
/// boxes, not shapes or filters.
namespace box2d
{

class Proxies
{
public:
    static constexpr int32 kTreeCount = 3; // by Mobility

    /// An id holds the tree's node and, in its lowest two bits, the mobility.
    static Mobility MobilityOf(int32 proxyId) { return static_cast<Mobility>(proxyId & 3); }

    int32 Create(const b2AABB& fatBox, Mobility mobility, b2FixtureProxy* proxy);
    void Destroy(int32 proxyId);
    /// Gives the proxy another box and marks it as moved.
    void Move(int32 proxyId, const b2AABB& fatBox);
    /// Marks it as moved, so that its pairs are looked for again.
    void Touch(int32 proxyId);
    const b2AABB& FatBox(int32 proxyId) const { return Tree(proxyId).GetFatAABB(proxyId >> 2); }
    b2FixtureProxy* Get(int32 proxyId) const
    {
        return static_cast<b2FixtureProxy*>(Tree(proxyId).GetUserData(proxyId >> 2));
    }

    bool HasMoved() const { return !m_moved.empty(); }

    /// Calls report(b2FixtureProxy* moved, b2FixtureProxy* other) for every overlapping pair with
    /// at least one moved proxy of which one could be dynamic, each pair once; then forgets what
    /// has moved. Pairs come in an order that depends on nothing but the calls made so far.
    template <class Report>
    void FindPairs(Report&& report);

    /// Calls report(b2FixtureProxy*) -> bool for every proxy whose box overlaps; false ends the
    /// query.
    template <class Report>
    void Query(const b2AABB& box, Report&& report) const;
    /// Of one mobility only; returns whether the report let it run to the end.
    template <class Report>
    bool Query(const b2AABB& box, Mobility mobility, Report&& report) const;

    const b2DynamicTree& TreeOf(Mobility mobility) const { return m_trees[int32(mobility)]; }
    void ShiftOrigin(const b2Vec2& newOrigin);
    int32 Count() const { return m_count; }

private:
    const b2DynamicTree& Tree(int32 proxyId) const { return m_trees[proxyId & 3]; }
    b2DynamicTree& Tree(int32 proxyId) { return m_trees[proxyId & 3]; }
    bool HasMoved(int32 proxyId) const;
    /// Builds the static tree anew when it has grown by half since that was done last, and by so
    /// many that it pays: a query looks at nearly half as many nodes then. All of it takes no
    /// longer than the insertions did.
    void RebuildStatic();

    enum Mark : uint8
    {
        kAtRest,
        kMoved,     // in m_moved
        kLookedFor, // its pairs have been reported
    };

    b2DynamicTree m_trees[kTreeCount];
    Array<uint8> m_marks[kTreeCount]; // by node: one of the above
    Array<int32> m_moved;             // ids, in the order they moved; some may be destroyed since
    int32 m_count = 0;
    int32 m_staticAdded = 0; // to the static tree since it was built anew
};

template <class Report>
void Proxies::FindPairs(Report&& report)
{
    RebuildStatic();
    for (std::size_t i = 0; i < m_moved.size(); ++i)
    {
        const int32 moved = m_moved[i];
        uint8& mark = m_marks[moved & 3][std::size_t(moved >> 2)];
        if (mark != kMoved)
        {
            continue; // destroyed since, or here a second time because the node was used again
        }
        mark = kLookedFor;
        const b2AABB box = FatBox(moved);
        const int32 firstTree =
            MobilityOf(moved) == Mobility::Dynamic ? 0 : int32(Mobility::Dynamic);
        for (int32 tree = firstTree; tree < kTreeCount; ++tree)
        {
            m_trees[tree].ForEachOverlap(box, [&](int32 node) {
                const int32 other = (node << 2) | tree;
                // When both have moved, the pair is reported from the larger id only.
                if (other != moved && !(other > moved && HasMoved(other)))
                {
                    report(Get(moved), Get(other));
                }
                return true;
            });
        }
    }
    for (const int32 moved : m_moved)
    {
        m_marks[moved & 3][std::size_t(moved >> 2)] = kAtRest;
    }
    m_moved.clear();
}

template <class Report>
bool Proxies::Query(const b2AABB& box, Mobility mobility, Report&& report) const
{
    const b2DynamicTree& tree = TreeOf(mobility);
    bool goOn = true;
    tree.ForEachOverlap(box, [&](int32 node) {
        goOn = report(static_cast<b2FixtureProxy*>(tree.GetUserData(node)));
        return goOn;
    });
    return goOn;
}

template <class Report>
void Proxies::Query(const b2AABB& box, Report&& report) const
{
    Query(box, Mobility::Static, report) && Query(box, Mobility::Kinematic, report) &&
        Query(box, Mobility::Dynamic, report);
}

} // namespace box2d
