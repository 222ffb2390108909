// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2DynamicTree.h>
#include <Box2D/Common/Array.h>
#include <Box2D/Internal/BodyData.h>

struct b2FixtureProxy;

/// The world's broad phase: a dynamic tree for each mobility, so that what never moves costs nothing,
/// and the list of proxies whose boxes have moved since pairs were last looked for. Knows boxes, not
/// shapes or filters.
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

    /// Calls report(b2FixtureProxy* moved, b2FixtureProxy* other) for every overlapping pair with at least one
    /// moved proxy of which one could be dynamic, each pair once; then forgets what has moved. Pairs come in an
    /// order that depends on nothing but the calls made so far.
    template <class Report>
    void FindPairs(Report&& report);

    /// Calls report(b2FixtureProxy*) -> bool for every proxy whose box overlaps; false ends the query.
    template <class Report>
    void Query(const b2AABB& box, Report&& report) const;
    template <class Report>
    void Query(const b2AABB& box, Mobility mobility, Report&& report) const;

    const b2DynamicTree& TreeOf(Mobility mobility) const { return m_trees[int32(mobility)]; }
    void ShiftOrigin(const b2Vec2& newOrigin);
    int32 Count() const { return m_count; }

private:
    struct PairQuery
    {
        Proxies* proxies;
        int32 tree;
        Array<int32>* found;
        bool QueryCallback(int32 node)
        {
            found->push_back((node << 2) | tree);
            return true;
        }
    };

    template <class Report>
    struct ReportQuery
    {
        const b2DynamicTree* tree;
        Report* report;
        bool goOn = true;
        bool QueryCallback(int32 node)
        {
            goOn = (*report)(static_cast<b2FixtureProxy*>(tree->GetUserData(node)));
            return goOn;
        }
    };

    const b2DynamicTree& Tree(int32 proxyId) const { return m_trees[proxyId & 3]; }
    b2DynamicTree& Tree(int32 proxyId) { return m_trees[proxyId & 3]; }
    bool HasMoved(int32 proxyId) const;

    enum Mark : uint8
    {
        kAtRest,
        kMoved,     // in m_moved
        kLookedFor, // its pairs have been reported
    };

    b2DynamicTree m_trees[kTreeCount];
    Array<uint8> m_marks[kTreeCount]; // by node: one of the above
    Array<int32> m_moved;             // ids, in the order they moved; some may be destroyed since
    Array<int32> m_found;             // scratch of FindPairs
    int32 m_count = 0;
};

template <class Report>
void Proxies::FindPairs(Report&& report)
{
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
        m_found.clear();
        const int32 firstTree = MobilityOf(moved) == Mobility::Dynamic ? 0 : int32(Mobility::Dynamic);
        for (int32 tree = firstTree; tree < kTreeCount; ++tree)
        {
            PairQuery query{this, tree, &m_found};
            m_trees[tree].Query(&query, box);
        }
        for (const int32 other : m_found)
        {
            // When both have moved, the pair is reported from the larger id only.
            if (other != moved && !(other > moved && HasMoved(other)))
            {
                report(Get(moved), Get(other));
            }
        }
    }
    for (const int32 moved : m_moved)
    {
        m_marks[moved & 3][std::size_t(moved >> 2)] = kAtRest;
    }
    m_moved.clear();
}

template <class Report>
void Proxies::Query(const b2AABB& box, Mobility mobility, Report&& report) const
{
    ReportQuery<Report> query{&TreeOf(mobility), &report};
    query.tree->Query(&query, box);
}

template <class Report>
void Proxies::Query(const b2AABB& box, Report&& report) const
{
    for (const b2DynamicTree& tree : m_trees)
    {
        ReportQuery<Report> query{&tree, &report};
        tree.Query(&query, box);
        if (!query.goOn)
        {
            return;
        }
    }
}

} // namespace box2d
