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
    /// Call once per step, after the blocks were prepared, the joints have begun and, if there are
    /// contacts, the awake islands were found. Selects the islands that are small enough.
    void Begin(SolverMemory& solver, JointSystem& joints);
    /// Returns the number of selected islands.
    std::size_t Count() const { return m_used.size(); }
    /// After iterations over all contacts: the velocities of the islands in which a contact's
    /// normal speed is off by more than `tolerance` [m/s].
    void SolveVelocities(SolverMemory& solver, JointSystem& joints, const SolverContext& context,
                         float32 tolerance);
    /// As above, for overlaps.
    void SolveOverlaps(SolverMemory& solver, JointSystem& joints, const SolverContext& context,
                       PushPace pace);

private:
    struct Place // place of a contact
    {
        int32 color, block, lane;
    };
    struct Pile
    {
        int32 island = -1; // of Islands; unused ones keep their last
        Array<Place> contacts;
        Array<int32> joints;   // indices in the JointSystem
        Array<RowSides> sides; // constraints of the current system
        BoundedSystem system;
        bool followed = false; // up to date in this step
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

    Array<int32> m_contacts; // contact count, by number of AwakeIslands
    Array<int32> m_pileOf;   // likewise; -1: none, or too large
    Array<Pile> m_piles;
    Array<int32> m_used;       // used in this step
    Array<int32> m_free;       // the others
    Array<RowSides> m_sides;   // scratch: of one island
    Elimination m_elimination; // of contact islands
    Array<SolverBody> m_moves; // by solver index: displacements in place of velocities, for
                               // overlaps
};

} // namespace box2d
