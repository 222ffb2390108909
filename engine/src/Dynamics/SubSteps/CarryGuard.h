// SPDX-License-Identifier: MIT
#pragma once

#include "JointSystem.h"

/// Whether the impulses that a kick starts with, those of the last, have done harm. Sweeps that
/// start from nothing only lower the kinetic energy that the kick has left. Those that start from
/// the impulses of an impact, which the present kick does not ask for, first have to take them
/// back, and where joints stand between contacts the few iterations of a kick do not: bodies come
/// out faster than they went in. Such islands are to be solved again from nothing.
namespace box2d
{

struct SolverMemory;
class World;

class CarryGuard
{
public:
    /// Call once per step, before its first kick, after the awake islands were found.
    void Begin(SolverMemory& solver, const JointSystem& joints);
    /// After the kick of the bodies, before the warm start.
    void Note(const World& world, const SolverMemory& solver);
    /// True if an island gained more energy than its motors, springs and kinematic bodies can
    /// supply.
    bool HasWon(const World& world, SolverMemory& solver, const JointSystem& joints);
    /// For these islands: restores the velocities of Note and resets the impulses of their
    /// contacts.
    void TakeBack(SolverMemory& solver) const;
    /// True if the island of these bodies gained energy.
    bool HasWon(const SolverMemory& solver, const RowSides& sides) const;
    /// Returns the number of islands checked.
    std::size_t Count() const { return m_islands.size(); }

private:
    struct Island
    {
        double before = 0.0, after = 0.0; ///< kinetic energy; before: plus the energy supplied
                                          ///< since [J]
        /// Driven by kinematic bodies, or iteratively solved and held together by warm starting
        /// only.
        bool exempt = false;
        bool HasWon() const;
    };

    bool HasWon(int32 island) const;
    void Exempt(int32 island, bool really);

    Array<Island> m_islands;    // by number of AwakeIslands
    Array<SolverBody> m_before; // by solver index
};

} // namespace box2d
