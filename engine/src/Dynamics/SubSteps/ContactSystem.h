// SPDX-License-Identifier: MIT
#pragma once

#include "../Direct/BoundedSystem.h"
#include "../Solver/ContactBlocks.h"
#include "../Solver/OverlapSolver.h"

/// Solves contact islands directly, in sub-steps. In a stack an iteration moves a load on by one
/// contact, and by half if the load is heavy. Islands are selected by their size: few contacts and
/// joints, and few loops, so that the cost is near that of iterations. An island is solved only if
/// iterations leave a residual, and one with joints only when no impact goes on in it.
namespace box2d
{

class AwakeIslands;
class JointSystem;
struct SolverMemory;

class ContactSystem
{
public:
    /// Errors of contacts up to this fraction of the speed that weight adds in a kick are left.
    /// Iterations end where none changes a speed by more. Islands that are small enough are solved
    /// directly where contacts are off by more. What is left in each kick makes a stack
    /// creep: with 0.01, one of 30 boxes leans by 11 cm in 20 s
    /// (docs/notes/sub-steps-direct-solver.md).
    static constexpr float32 kTolerance = 1e-4f;
    /// Overlaps that iterations leave above this are brought to less [m]: under any load less than
    /// a slop is left. It is between the slop and kRestOverlap, at which the solution aims. With
    /// 0.82, 1 and 1.5 slops stacks of 16 to 50 boxes stand as well; nothing else was compared.
    static constexpr float32 kMaxOverlap = 0.95f * b2_linearSlop;

    /// Call once per step, after the blocks were prepared and the awake islands were found.
    void CountContacts(SolverMemory& solver);
    /// True if an island has too many contacts to be solved directly; a number of AwakeIslands.
    bool IsLarge(int32 island) const;
    /// Call after that, and after the joints have begun. Selects the islands that are small enough.
    void Begin(SolverMemory& solver, JointSystem& joints);
    /// Builds the systems of the selected islands that have changed now, because groups that
    /// threads solve must not allocate.
    void FollowAll(SolverMemory& solver, JointSystem& joints);
    /// Returns the number of selected islands.
    std::size_t Count() const { return m_used.size(); }
    /// Call after iterations over a group's contacts. Solves the velocities of its islands in which
    /// a contact or a joint is off by more than the tolerance [m/s]. That is kTolerance of
    /// `weight`, the speed that weight adds in the kick, plus a minimum for islands without weight.
    void SolveVelocities(SolverMemory& solver, const IslandGroup& group, JointSystem& joints,
                         const SolverContext& context, float32 weight);
    /// To be called instead if the iterations have already solved the velocities.
    void NoteBalance(const IslandGroup& group);
    /// Same as SolveVelocities, for islands with overlaps deeper than kMaxOverlap.
    void SolveOverlaps(SolverMemory& solver, const IslandGroup& group, JointSystem& joints,
                       const SolverContext& context, PushPace pace);

private:
    struct Place // place of a contact
    {
        int32 color, block, lane;
    };
    struct ContactIsland
    {
        int32 id = -1; // of Islands; unused ones keep their last
        Array<Place> contacts;
        Array<int32> joints;   // indices in the JointSystem
        Array<RowSides> sides; // constraints of the current system
        BoundedSystem system;
        bool followed = false;   // up to date in this step
        bool inImpact = false;   // in the last kick, and left to iterations
        float32 residual = 0.0f; // of the last kick's iterations [m/s]
    };

    struct Speeds // [m/s]
    {
        float32 tolerance; // of a solution
        float32 weight;    // that weight adds in a kick, and kMinWeight
    };

    static float32 MinSeparation(const ContactIsland& island, const SolverMemory& solver,
                                 const SolverBody* bodies);
    static bool MayContradict(const ContactIsland& island, const SolverMemory& solver,
                              const SolverBody* bodies);
    static bool IsAtRisk(const ContactIsland& island, SolverMemory& solver,
                         const JointSystem& joints);
    void ChooseContactIslands(const AwakeIslands& islands);
    void Gather(SolverMemory& solver, JointSystem& joints);
    bool Follow(ContactIsland& island, SolverMemory& solver, JointSystem& joints);
    bool SolveVelocities(ContactIsland& island, SolverMemory& solver, JointSystem& joints,
                         const SolverContext& context, const Speeds& speeds);
    void SolveOverlaps(ContactIsland& island, SolverMemory& solver, JointSystem& joints,
                       const SolverContext& context, PushPace pace);
    void FindResiduals(const SolverMemory& solver, const IslandGroup& group,
                       const SolverBody* bodies, float32 maxRounding);
    template <class Function>
    void ForSelected(const IslandGroup& group, Function&& function);
    int32 TakeContactIsland();
    void FindRoom(ContactIsland& island);
    template <class Function>
    void ForContacts(SolverMemory& solver, Function&& function) const;

    Array<int32> m_contacts;        // contact count, by number of AwakeIslands
    Array<int32> m_contactIslandOf; // likewise; -1: none, or too large
    Array<ContactIsland> m_contactIslands;
    Array<int32> m_used;       // used in this step
    Array<int32> m_free;       // the others
    Array<RowSides> m_sides;   // scratch: of one island
    Elimination m_elimination; // of contact islands
    Array<SolverBody> m_moves; // by solver index: displacements in place of velocities, for
                               // overlaps
};

} // namespace box2d
