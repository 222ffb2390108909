// SPDX-License-Identifier: MIT
#pragma once

#include "../../Common/ThreadPool.h"

#include <Box2D/Collision/b2DynamicTree.h>
#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

#include <algorithm>

struct b2FixtureProxy;

/// The world's broad phase: a dynamic tree per body type, and the list of proxies moved since the
/// last search for pairs. Separate trees make static bodies free of cost. Independent of shapes and
/// filters.
namespace box2d
{

struct SnapshotAccess;

class Proxies
{
public:
    static constexpr int32 kTreeCount = 3; // by Mobility

    static constexpr int32 kTreeBits = 2;

    /// An id consists of the tree's node and, in the lowest two bits, the mobility.
    static Mobility MobilityOf(int32 proxyId) { return static_cast<Mobility>(proxyId & 3); }

    /// `categories`: bits for MayMeet [all].
    int32 Create(const b2AABB& fatBox, Mobility mobility, b2FixtureProxy* proxy,
                 uint16 categories = 0xFFFF);
    void Destroy(int32 proxyId);
    /// Sets the proxy's box and marks it as moved.
    void Move(int32 proxyId, const b2AABB& fatBox);
    /// Same as Move, but cheaper, for a box that has only grown and will change again soon.
    void Grow(int32 proxyId, const b2AABB& fatBox);
    /// Proxies of `count` bodies are moved between these two calls, of which `bullets` will leave
    /// their boxes again in the next step. If that is a large part of all, the tree is built again
    /// at the end. No query is allowed meanwhile.
    void BeginMoves(int32 count, int32 bullets);
    void EndMoves();
    /// Marks it as moved, so that its pairs are searched again.
    void Touch(int32 proxyId);
    void SetCategories(int32 proxyId, uint16 categories);
    /// True if a proxy of the mobility has one of these categories.
    bool MayMeet(uint16 categories, Mobility mobility) const
    {
        return (m_present[int32(mobility)] & categories) != 0;
    }
    const b2AABB& FatBox(int32 proxyId) const { return Tree(proxyId).GetFatAABB(proxyId >> 2); }
    b2FixtureProxy* Get(int32 proxyId) const
    {
        return static_cast<b2FixtureProxy*>(Tree(proxyId).GetUserData(proxyId >> 2));
    }

    bool HasMoved() const { return !m_moved.empty(); }

    /// Calls report(b2FixtureProxy* moved, b2FixtureProxy* other) once for every overlapping pair
    /// with at least one moved proxy and one that could be dynamic. Then clears the moved marks.
    /// The order of pairs depends only on the sequence of calls.
    /// All threads search the trees. For each moved proxy they search those for which
    /// isWanted(b2FixtureProxy* moved, Mobility) is true. They skip pairs for which
    /// isKnown(int32 movedId, int32 otherId) is true. Reports come from the calling
    /// thread.
    template <class IsWanted, class IsKnown, class Report>
    void FindPairs(ThreadPool* threads, IsWanted&& isWanted, IsKnown&& isKnown, Report&& report);

    /// Calls report(b2FixtureProxy*) -> bool for every proxy whose box overlaps; false ends the
    /// query.
    template <class Report>
    void Query(const b2AABB& box, Report&& report) const;
    /// Same as above, for one mobility; false if the report ended the query.
    template <class Report>
    bool Query(const b2AABB& box, Mobility mobility, Report&& report) const;

    const b2DynamicTree& TreeOf(Mobility mobility) const { return m_trees[int32(mobility)]; }
    const b2DynamicTree* Trees() const { return m_trees; } ///< kTreeCount trees, by mobility
    void ShiftOrigin(const b2Vec2& newOrigin);
    int32 Count() const { return m_count; }

private:
    friend struct SnapshotAccess;
    const b2DynamicTree& Tree(int32 proxyId) const { return m_trees[proxyId & 3]; }
    b2DynamicTree& Tree(int32 proxyId) { return m_trees[proxyId & 3]; }
    enum Mark : uint8
    {
        kAtRest,
        kMoved,     // in m_moved
        kLookedFor, // its pairs have been or will be reported
    };

    bool HasMoved(int32 proxyId) const
    {
        return m_marks[proxyId & 3][std::size_t(proxyId >> 2)] != kAtRest;
    }
    /// Builds the static tree again when it has grown by half since the last time, and by enough
    /// proxies to be worthwhile. A query then visits nearly half as many nodes. Rebuilding takes no
    /// longer than the insertions did.
    void RebuildStatic();

    struct Pair
    {
        int32 moved, other; // ids
    };
    /// Pairs found for a few moved proxies. If they exceed the capacity, the calling thread repeats
    /// the search, because only it may allocate.
    struct Found
    {
        // They affect the time only. A proxy seldom has more than four new pairs in a step: what is
        // packed has six neighbours, most of which it had before.
        static constexpr int32 kProxies = 16;
        static constexpr int32 kRoom = 4 * kProxies;
        int32 count;
        bool complete;
        Pair pairs[kRoom];
    };

    /// Reduces the list to moved proxies that still exist, each once.
    void ListMoved();
    template <class IsWanted, class IsKnown, class Report>
    void FindPairsOf(int32 moved, const IsWanted& isWanted, const IsKnown& isKnown,
                     Report&& report) const;
    template <class IsKnown, class Report>
    void FindDynamicPairs(const IsKnown& isKnown, const Report& report) const;
    template <class IsWanted, class IsKnown>
    void FindPairsOf(int32 begin, int32 end, const IsWanted& isWanted, const IsKnown& isKnown,
                     Found& found) const;
    void Count(int32 tree, uint16 categories, int32 change);

    b2DynamicTree m_trees[kTreeCount];
    Array<uint8> m_marks[kTreeCount];       // by node: one of the above
    Array<uint16> m_categories[kTreeCount]; // by node
    int32 m_categoryCounts[kTreeCount][16] = {};
    uint16 m_present[kTreeCount] = {}; // union of all proxies' categories
    Array<int32> m_moved;              // ids, in the order of moves; may contain destroyed ones
    Array<Found> m_found;              // per part of the parallel search
    int32 m_count = 0;
    int32 m_staticAdded = 0; // to the static tree since it was last built
    bool m_rebuilds = false; // the dynamic tree, at the end of the present moves
    int32 m_refits = 0;      // since the dynamic tree was last built, plus 1
    bool m_rebuilt = false;  // it was, since pairs were last looked for
};

template <class IsWanted, class IsKnown, class Report>
void Proxies::FindPairsOf(int32 moved, const IsWanted& isWanted, const IsKnown& isKnown,
                          Report&& report) const
{
    const b2AABB box = FatBox(moved);
    b2FixtureProxy* const proxy = Get(moved);
    const bool dynamic = MobilityOf(moved) == Mobility::Dynamic;
    const int32 firstTree = dynamic ? 0 : int32(Mobility::Dynamic);
    const int32 lastTree = int32(dynamic && m_rebuilt ? Mobility::Kinematic : Mobility::Dynamic);
    for (int32 tree = firstTree; tree <= lastTree; ++tree)
    {
        if (!isWanted(proxy, static_cast<Mobility>(tree)))
        {
            continue;
        }
        m_trees[tree].ForEachOverlap(box, [&](int32 node) {
            const int32 other = (node << 2) | tree;
            // If both have moved, the pair is reported from the larger id only.
            return other == moved || (other > moved && HasMoved(other)) || isKnown(moved, other) ||
                   report(other);
        });
    }
}

/// If many dynamic proxies have moved, all their pairs are found in one pass.
template <class IsKnown, class Report>
void Proxies::FindDynamicPairs(const IsKnown& isKnown, const Report& report) const
{
    const int32 dynamic = int32(Mobility::Dynamic);
    const b2DynamicTree& tree = m_trees[dynamic];
    const Array<uint8>& marks = m_marks[dynamic];
    tree.ForEachPair([&](int32 a, int32 b) {
        const int32 first = b2Min(a, b);
        const int32 second = b2Max(a, b);
        const bool moved =
            marks[std::size_t(first)] != kAtRest || marks[std::size_t(second)] != kAtRest;
        const int32 one = (first << 2) | dynamic;
        const int32 another = (second << 2) | dynamic;
        if (moved && !isKnown(one, another))
        {
            report(Get(one), Get(another));
        }
    });
}

template <class IsWanted, class IsKnown>
void Proxies::FindPairsOf(int32 begin, int32 end, const IsWanted& isWanted, const IsKnown& isKnown,
                          Found& found) const
{
    found.count = 0;
    found.complete = true;
    for (int32 i = begin; i < end && found.complete; ++i)
    {
        const int32 moved = m_moved[std::size_t(i)];
        FindPairsOf(moved, isWanted, isKnown, [&](int32 other) {
            found.complete = found.count < Found::kRoom;
            if (found.complete)
            {
                found.pairs[found.count++] = {moved, other};
            }
            return found.complete;
        });
    }
}

template <class IsWanted, class IsKnown, class Report>
void Proxies::FindPairs(ThreadPool* threads, IsWanted&& isWanted, IsKnown&& isKnown,
                        Report&& report)
{
    RebuildStatic();
    ListMoved();
    const int32 count = int32(m_moved.size());
    const auto reportAll = [&](int32 begin, int32 end) {
        for (int32 i = begin; i < end; ++i)
        {
            const int32 moved = m_moved[std::size_t(i)];
            FindPairsOf(moved, isWanted, isKnown, [&](int32 other) {
                report(Get(moved), Get(other));
                return true;
            });
        }
    };
    if (threads == nullptr || count < 4 * Found::kProxies)
    {
        reportAll(0, count);
    }
    else
    {
        const int32 groups = (count + Found::kProxies - 1) / Found::kProxies;
        const auto beginOf = [&](int32 group) { return b2Min(group * Found::kProxies, count); };
        m_found.resize(b2Max(m_found.size(), std::size_t(groups)));
        ParallelFor(threads, groups, 1, [&](int32 first, int32 last) {
            for (int32 group = first; group < last; ++group)
            {
                FindPairsOf(beginOf(group), beginOf(group + 1), isWanted, isKnown,
                            m_found[std::size_t(group)]);
            }
        });
        for (int32 group = 0; group < groups; ++group)
        {
            const Found& found = m_found[std::size_t(group)];
            for (int32 i = 0; i < found.count && found.complete; ++i)
            {
                report(Get(found.pairs[i].moved), Get(found.pairs[i].other));
            }
            if (!found.complete)
            {
                reportAll(beginOf(group), beginOf(group + 1));
            }
        }
    }
    const auto isSought = [&](int32 moved) { return isWanted(Get(moved), Mobility::Dynamic); };
    if (m_rebuilt && std::ranges::any_of(m_moved, isSought))
    {
        FindDynamicPairs(isKnown, report);
    }
    m_rebuilt = false;
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
