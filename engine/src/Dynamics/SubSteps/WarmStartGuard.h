// SPDX-License-Identifier: MIT
#pragma once

#include "ContactSystem.h"
#include "JointSystem.h"

#include <span>

/// Detects islands that gain energy by the warm start of a kick. Iterations from zero impulses only
/// lower the kinetic energy after the kick. A warm start with the impulses of a past impact must be
/// undone first. Where joints connect contacts, the few iterations of a kick do not suffice for
/// that, and bodies gain speed. Such islands are solved again from zero impulses. Exempt are those
/// that are too large to be solved directly or have iterated joints.
namespace box2d
{

struct IslandGroup;
struct SolverMemory;

class WarmStartGuard
{
public:
    /// Call once per step, before its first kick, after the contacts were counted and the joints
    /// have begun.
    void Begin(SolverMemory& solver, const JointSystem& joints, const ContactSystem& contacts);
    /// After the kick of the bodies, before the warm start.
    void Note(const SolverMemory& solver, const IslandGroup& group);
    /// True if an island gained more energy than its motors, springs and kinematic bodies can
    /// supply.
    bool HasGained(SolverMemory& solver, const IslandGroup& group, const BodyKick* kicks,
                   const JointSystem& joints);
    /// For these islands: restores the velocities of Note and resets the impulses of their
    /// contacts.
    void Restore(SolverMemory& solver, const IslandGroup& group) const;
    /// True if the island of these bodies gained energy.
    bool HasGained(const SolverMemory& solver, const RowSides& sides) const;
    /// Returns the number of awake islands.
    std::size_t Count() const { return m_islands.size(); }

private:
    struct Island
    {
        double before = 0.0, after = 0.0; ///< kinetic energy; before: plus the energy supplied
                                          ///< since [J]
        /// Held by warm starting and iterations: without its impulses, a large island would fall
        /// until iterations had found them again.
        bool exempt = false;
        bool HasGained() const;
    };

    void FindEnergies(const SolverMemory& solver, const IslandGroup& group, const BodyKick* kicks);
    void AddDrives(SolverMemory& solver, const IslandGroup& group);
    std::span<Island> Of(const IslandGroup& group);
    bool HasGained(int32 island) const;
    void Exempt(int32 island, bool really);

    Array<Island> m_islands; // by number of AwakeIslands
    bool m_checksAny = false;
    bool m_anyMoves = false;    // a platform
    Array<SolverBody> m_before; // by solver index
};

} // namespace box2d
