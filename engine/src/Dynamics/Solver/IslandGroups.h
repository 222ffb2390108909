// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>

/// Ranges of the awake bodies that no island spans. The solver passes over bodies and contacts many
/// times in a step. If it finishes one range before the next, it finds them in a cache. Measured in
/// docs/notes/island-groups.md.
namespace box2d
{

class AwakeIslands;
struct SnapshotAccess;

/// One of them, or all bodies.
struct IslandGroup
{
    int32 number = -1;                    ///< -1: all
    int32 firstBody = 0, endBody = 0;     ///< indices of awake bodies
    int32 firstIsland = 0, endIsland = 0; ///< numbers of AwakeIslands
};

class IslandGroups
{
public:
    /// Minimum number of bodies of a group, except for the last one. With their contacts they take
    /// about half a megabyte, half of a second-level cache of 1 MB. With 256 and 1024, 100 pyramids
    /// take 1.06 and 1.03 of the time (docs/notes/island-groups.md).
    static constexpr int32 kBodies = 512;
    /// Maximum number of groups; they are larger then. Enough for the parts of many threads. The
    /// sum of this and of the 64 buckets of ContactBlocks must fit into the byte of a bucket
    /// number.
    static constexpr int32 kMaxCount = 64;

    /// All `bodies` awake bodies are one group.
    void Join(int32 bodies);
    /// True if the last division still holds, of bodies and islands with this key.
    bool Keep(std::uint64_t key);
    /// Divides the awake bodies, if each belongs to an island. The key changes with their order and
    /// their islands.
    void Divide(const AwakeIslands& islands, int32 bodies, std::uint64_t key);

    int32 Count() const { return int32(m_ends.size()); }
    IslandGroup At(int32 number) const;
    /// Returns the number of the group of an awake body.
    int32 Of(int32 body) const { return Count() == 1 ? 0 : m_ofBody[std::size_t(body)]; }
    /// True if bodies may be in other groups than in the last step.
    bool HasChanged() const { return m_changed; }
    /// True if there would be twice as many groups with the bodies in the order of their islands.
    bool WantsOrder() const { return m_wantsOrder; }

private:
    friend struct SnapshotAccess;
    static constexpr std::uint64_t kNoKey = ~std::uint64_t(0);
    struct End
    {
        int32 body, island;
    };

    void FindEnds(const AwakeIslands& islands, int32 bodies, int32 least);
    int32 CountInOrder(int32 least) const;

    Array<End> m_ends;
    Array<uint8> m_ofBody;
    Array<int32> m_lastOf; // by island: its last body
    Array<int32> m_sizes;  // by island: its bodies
    std::uint64_t m_key = kNoKey;
    bool m_changed = false;
    bool m_wantsOrder = false;
};

} // namespace box2d
