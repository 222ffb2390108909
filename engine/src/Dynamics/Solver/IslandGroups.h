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
    /// Least number of bodies of a group: with their contacts about half a megabyte.
    static constexpr int32 kBodies = 512;
    /// Maximum number of groups; they are larger then.
    static constexpr int32 kMaxCount = 64;

    /// All `bodies` awake bodies are one group.
    void Join(int32 bodies);
    /// True if the groups of the last step still hold, whose bodies and islands had this key.
    bool Keep(int32 key);
    /// Divides the awake bodies, if each belongs to an island. `order` changes with their order,
    /// `key` with that or with an island.
    void Divide(const AwakeIslands& islands, int32 bodies, int32 order, int32 key);

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
    struct End
    {
        int32 body, island;
    };

    int32 CountInOrder(int32 least) const;

    Array<End> m_ends, m_last;
    Array<uint8> m_ofBody;
    Array<int32> m_lastOf;          // by island: its last body
    Array<int32> m_sizes;           // by island: its bodies
    int32 m_order = -1, m_key = -1; // of the last division
    bool m_changed = false;
    bool m_wantsOrder = false;
};

} // namespace box2d
