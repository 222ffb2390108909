// SPDX-License-Identifier: MIT
#pragma once

#include "../Direct/BoundedSystem.h"
#include "../Solver/ContactBlocks.h"

/// Piles that iterations do not bring to rest, solved exactly, in sub-steps: where a body lies on
/// another that lies on another, an iteration carries a load one contact further, and half of a
/// heavy one. For islands of so few contacts and joints, and of so few loops, that this costs
/// little more than iterations do, and only where these have left something to do.
namespace box2d
{

class AwakeIslands;
class JointSystem;
class JointSystem;
struct SolverMemory;

class ContactSystem
{
public:
    /// Once a step, when the blocks are prepared, the joints have begun and, where there are
    /// contacts, the awake islands have been found: which islands are small enough.
    void Begin(SolverMemory& solver, JointSystem& joints);
    /// How many are.
    std::size_t Count() const { return m_used.size(); }
    /// After iterations over all contacts: the velocities of the islands in which a contact's
    /// normal speed is off by more than `tolerance` [m/s].
    void SolveVelocities(SolverMemory& solver, JointSystem& joints, const SolverContext& context,
                         float32 tolerance);
    /// The same of overlaps.
    void SolveOverlaps(SolverMemory& solver, JointSystem& joints, const SolverContext& context,
                       PushPace pace);

private:
    struct Place // of a contact
    {
        int32 color, block, lane;
    };
    struct Pile
    {
        int32 island = -1; // of Islands; those that are free keep their last
        Array<Place> contacts;
        Array<int32> joints;   // of the JointSystem
        Array<RowSides> sides; // for which the system was built
        BoundedSystem system;
        bool followed = false; // in this step
    };

    void CountContacts(SolverMemory& solver);
    void ChoosePiles(const AwakeIslands& islands);
    void Gather(SolverMemory& solver, JointSystem& joints);
    bool Follow(Pile& pile, SolverMemory& solver, JointSystem& joints);
    void SolveVelocities(Pile& pile, SolverMemory& solver, JointSystem& joints,
                         const SolverContext& context, float32 tolerance);
    void SolveOverlaps(Pile& pile, SolverMemory& solver, JointSystem& joints,
                       const SolverContext& context, PushPace pace);
    int32 TakePile();
    void FindRoom(Pile& pile);
    template <class Function>
    void ForContacts(SolverMemory& solver, Function&& function) const;

    Array<int32> m_contacts; // how many, by number of AwakeIslands
    Array<int32> m_pileOf;   // the same; -1: none, or too large
    Array<Pile> m_piles;
    Array<int32> m_used;       // piles of this step
    Array<int32> m_free;       // the others
    Array<RowSides> m_sides;   // scratch: of a pile
    Elimination m_elimination; // of piles
    Array<SolverBody> m_moves; // by solver index: in place of velocities when overlaps are solved
};

} // namespace box2d
