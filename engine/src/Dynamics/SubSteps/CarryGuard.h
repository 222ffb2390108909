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
    /// Once a step, before its first kick, when the awake islands have been found.
    void Begin(SolverMemory& solver, const JointSystem& joints);
    /// After the kick of the bodies, before the warm start.
    void Note(const World& world, const SolverMemory& solver);
    /// Whether an island has won energy that neither its motors and springs nor what moves by
    /// itself can have given.
    bool HasWon(const World& world, SolverMemory& solver, const JointSystem& joints);
    /// Of the islands that have: gives the bodies back their velocities of Note, and takes the
    /// impulses from their contacts.
    void TakeBack(SolverMemory& solver) const;
    /// Whether the island of these bodies has.
    bool HasWon(const SolverMemory& solver, const RowSides& sides) const;
    /// How many islands it looks at.
    std::size_t Count() const { return m_islands.size(); }

private:
    struct Island
    {
        double before = 0.0, after = 0.0; ///< kinetic energy; before, also what was given since [J]
        /// Driven by what moves by itself, or swept over where nothing but what was carried over
        /// holds it together.
        bool exempt = false;
        bool HasWon() const;
    };

    bool HasWon(int32 island) const;
    void Exempt(int32 island, bool really);

    Array<Island> m_islands;    // by number of AwakeIslands
    Array<SolverBody> m_before; // by solver index
};

} // namespace box2d
