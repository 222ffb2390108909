// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>
#include <Box2D/Dynamics/b2World.h>

#include <memory>

class b2DynamicTree;
struct b2FixtureProxy;

namespace box2d
{

class ConstraintGraph;
class ContactBlocks;
class IslandGroups;
class EnergyGuard;
class Islands;
class JointSystem;
class Proxies;
class World;

/// Gives the snapshot access to private members of the engine. Each visitor is in the header of its
/// part, beside this one. All of them name every member of their part, so a new member does not
/// compile until its visitor handles it.
struct SnapshotAccess
{
    static std::unique_ptr<World>& Of(b2World& world) { return world.m_world; }
    static World& Of(const b2World& world) { return *world.m_world; }

    // BroadPhaseState.h
    template <class Archive>
    static void Visit(Archive& archive, b2DynamicTree& tree);
    template <class Archive>
    static void Visit(Archive& archive, Proxies& proxies);
    static bool IsSound(const b2DynamicTree& tree);
    /// True if the restored trees contain such a leaf.
    static bool IsProxy(const Proxies& proxies, int32 proxyId);
    /// Assigns a leaf to its fixture; false if the leaf does not exist or is already assigned.
    static bool Connect(Proxies& proxies, b2FixtureProxy& proxy);
    static bool AreAllConnected(const Proxies& proxies);
    // ListState.h
    template <class Archive>
    static void Visit(Archive& archive, Islands& islands);
    template <class Archive>
    static void Visit(Archive& archive, ConstraintGraph& graph);
    // SolverState.h
    template <class Archive>
    static void Visit(Archive& archive, EnergyGuard& guard, const World& world);
    template <class Archive>
    static void Visit(Archive& archive, JointSystem& system, const World& world);
    template <class Archive>
    static void Visit(Archive& archive, ContactBlocks& blocks, const World& world, int32 color);
    template <class Archive>
    static void Visit(Archive& archive, IslandGroups& groups);
};

} // namespace box2d
