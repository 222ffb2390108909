// SPDX-License-Identifier: MIT
#pragma once

#include "../Direct/BoundedSystem.h"
#include "../Joints/JointSchedule.h"
#include "Closing.h"
#include "HingeTree.h"

#include <algorithm>
#include <cmath>

/// All effects of joints in sub-steps. Rigid rows form a RowSystem. Motors and limits are part of
/// it as long as their forces have the right direction. The active set is found by block pivoting
/// (Judice and Pires, "A block principal pivoting algorithm for large-scale strictly monotone
/// linear complementarity problems", 1994). Iterations in lanes, as in a whole step, solve a
/// component with too many loops, and one in a contact island that is iterated anyway.
namespace box2d
{

struct SnapshotAccess;

class ConstraintGraph;

/// The state of a body after impacts within a step.
enum class AfterImpact : uint8
{
    Free,
    Leans,   ///< supported by a static body: moving it would cause an overlap
    Stopped, ///< its pose is no longer that of the step
};

class JointSystem
{
public:
    /// Follows the graph's list of joints, and which of their bodies are awake. Free while the list
    /// and `awakeVersion`, that of World, are unchanged.
    void Update(const ConstraintGraph& graph, std::uint32_t awakeVersion);
    bool IsEmpty() const { return m_joints.empty(); }
    /// True if one call of SolveVelocities suffices.
    bool IsExact() const { return m_iterated.IsEmpty(); }
    std::size_t Count() const { return m_joints.size(); }
    b2Joint& At(std::size_t joint) const { return *m_joints[joint]; }
    const JointRows& Rows(std::size_t joint) const { return m_system.Rows(joint); }
    const RowSides& Sides(std::size_t joint) const { return m_sides[joint]; }

    /// Call at the start of a step: reads the impulses of the joints, times `share`.
    /// `lastInverseStep`: one over the length of the last step. `isInLarge`: true for a body whose
    /// contacts are too many to be solved directly. `threads`: for iterations in this step; null:
    /// the calling thread alone.
    template <class IsInLarge>
    void Begin(const SolverContext& context, float32 share, float32 lastInverseStep,
               const BodyKick* kicks, ThreadPool* threads, IsInLarge&& isInLarge)
    {
        m_threads = threads;
        for (int32 i = 0; i < m_system.Components(); ++i)
        {
            bool inLarge = false;
            m_system.ForBodies(i, [&](const BodyData& body, std::size_t) {
                inLarge = inLarge || isInLarge(body);
            });
            m_parts[std::size_t(i)] = Part();
            m_parts[std::size_t(i)].iterated = inLarge && !IsAtRisk(i);
        }
        BeginParts(context, share, lastInverseStep, kicks);
    }
    /// Moves independent trees through the whole step in StepTrees; all other functions skip them.
    template <class Function>
    void ForTreeBodies(Function&& function) const
    {
        for (const Part& part : m_parts)
        {
            if (part.tree != nullptr)
            {
                part.tree->ForBodies(function);
            }
        }
    }
    /// True if there are joints outside of trees.
    bool HasRows() const { return !m_rowed.empty() || !m_iterated.IsEmpty(); }
    void StepTrees(float32 timeStep, int32 subSteps, float32 lastStep);
    /// Computes the rows at the current poses and the velocities before a kick. The context has the
    /// step of the kick, and the inverse step of the following drift.
    void Prepare(const SolverContext& context);
    /// Call after the kick: applies the last impulses, times `share`.
    void WarmStart(const SolverContext& context, float32 share);
    /// Same as above, for joints whose sides satisfy `which`: without impulses, but for motors and
    /// friction at their maximum.
    template <class Function>
    void StartAgain(const SolverContext& context, Function&& which)
    {
        for (const std::size_t i : m_rowed)
        {
            if (which(m_sides[i]))
            {
                Start(context, i, 0.0f);
            }
        }
    }
    /// Calls the function for each joint that is iterated over.
    template <class Function>
    void ForIterated(Function&& function) const
    {
        std::for_each(m_iteratedJoints.begin(), m_iteratedJoints.end(), function);
    }
    /// Calls the function for all rows that are solved directly, with the index.
    template <class Function>
    void ForRowed(Function&& function) const
    {
        for (const std::size_t i : m_rowed)
        {
            function(i, m_system.Rows(i));
        }
    }
    /// Returns the maximum work of a joint's motors, springs and limits by the impulses of a kick
    /// [J]. An impulse acts on a body below its target speed, and does at most the work at the mean
    /// of the speeds before and after. The target speed of a spring may be thousands of metres per
    /// second.
    double MaxWork(std::size_t joint, const SolverContext& before,
                   const SolverContext& after) const;
    /// Brings all rows to their target speeds; components without contacts only the first time.
    void SolveVelocities(const SolverContext& context, bool first);
    /// Call before a drift.
    void NotePoses(const SolverContext& context);
    /// Call after the bodies moved for `timeStep`. Closes the joints by impulses along the rows of
    /// Prepare, which change velocities and displacements. (RATTLE: Andersen, "Rattle: a 'velocity'
    /// version of the Shake algorithm", 1983.) The kicks are by awake body.
    void SolvePositions(const SolverContext& context, float32 timeStep, const BodyKick* kicks);
    /// Closes the joints that the position correction of overlaps opened since SolvePositions. Call
    /// it after that correction. Iterated joints are closed only here.
    void CloseAfterPushes(const SolverContext& context, int32 iterations);
    /// Call after write-back and before an impact within the step: records the gaps of joints.
    void NoteOpen(const ConstraintGraph& graph, std::uint32_t awakeVersion,
                  const SolverContext& context);
    /// Call after impacts within the step, which moved some bodies. Closes the components of bodies
    /// selected by `fate`. The context's bodies have no displacements before, and receive them
    /// here. Calls `changed` for each of these components.
    template <class Fate, class Changed>
    void CloseAfterImpacts(const ConstraintGraph& graph, const SolverContext& context, Fate&& fate,
                           Changed&& changed)
    {
        FollowOpen(graph, context);
        for (int32 i = 0; i < m_system.Components(); ++i)
        {
            if (!HoldStopped(i, fate))
            {
                continue;
            }
            m_parts[std::size_t(i)].torn = false; // the added masses are those of HoldStopped
            ClosePoses(i, context);
            LetGo(i);
            changed(i);
        }
    }
    // Calls the function for each body of a component.
    template <class Function>
    void ForJoints(int32 part, Function&& function) const
    {
        m_system.ForItems(part, [&](std::size_t item) { function(*m_joints[item]); });
    }
    template <class Function>
    void ForBodies(int32 part, Function&& function) const
    {
        m_system.ForBodies(part, [&](const BodyData& body, std::size_t) { function(body); });
    }
    /// Stores the sums of the step's impulses in the joints.
    void End();

    /// A joint as part of a larger system. Call after SolveVelocities for its rows; TakeItem stores
    /// the solved impulses.
    void FillItem(std::size_t joint, JointRows& rows, BoundedSystem::Item& item) const;
    /// Returns by how much the joint's rows miss their target speeds, angles at a body's reach
    /// [m/s].
    float32 ErrorOf(std::size_t joint, const SolverContext& context) const;
    void TakeItem(std::size_t joint, const BoundedSystem::Item& item);
    /// Same as above, with displacements instead of velocities. Rigid rows and active limits must
    /// not move. Motors and springs are omitted, because they have target velocities.
    void FillDisplacements(std::size_t joint, JointRows& rows, BoundedSystem::Item& item) const;

private:
    friend struct SnapshotAccess;
    struct Impulses
    {
        float32 at[JointRows::kMaxRows];
    };
    /// The state of a bounded row.
    enum class RowState : uint8
    {
        Holds,   ///< active: its speed is the target
        AtMax,   ///< inactive: its impulse is at the maximum
        AtMin,   ///< inactive: its impulse is at the minimum
        Slowest, ///< active: its speed is at a bound, with any impulse
        Fastest,
    };
    struct RowStates
    {
        RowState of[JointRows::kMaxRows] = {};
    };
    /// The solution method of a joint in a step.
    enum class Solution : uint8
    {
        Rows,     ///< directly
        Tree,     ///< by its HingeTree
        Iterated, ///< in lanes
    };
    /// Sums over the kicks of a step.
    struct Totals
    {
        float32 within[JointRows::kMaxRows] = {};
        float32 beyond[JointRows::kMaxRows] = {};
    };
    /// A connected component.
    struct Part
    {
        bool touched = false;    ///< by contacts
        bool iterated = false;   ///< in this step
        bool hasBounded = false; ///< contains bounded rows
        bool driven = false;     ///< contains bounded rows other than limits
        bool lines = false;      ///< contains ropes and rods
        bool damped = false;
        bool torn = false; ///< its bodies have added mass
        bool factored = false;
        HingeTree* tree = nullptr;     ///< moves the component through this step
        double squaredFrequency = 0.0; ///< see RowSystem; from the last step's mean forces

        /// True if the component is solved directly.
        bool IsByRows() const { return tree == nullptr && !iterated; }
    };

    // JointActiveSet.cpp
    static void Validate(const JointRows& rows, RowStates& states);
    float32 WarmStartImpulse(std::size_t joint, int32 row, float32 share) const;
    static double WantedSpeed(const JointRows& rows, RowState state, int32 row, double impulse);
    void SetActive(std::size_t joint);
    bool IsHeld(std::size_t joint, int32 row, const SolverContext& context) const;
    bool SetActiveToClose(std::size_t joint, const SolverContext& context);
    void WantSpeeds(std::size_t joint, const SolverContext& context);
    bool Reconsider(std::size_t joint, const SolverContext& context, bool settles);
    bool Reconsider(const SolverContext& context, std::size_t joint, int32 row, float32 speed,
                    bool settles);
    bool ReconsiderDisc(const SolverContext& context, std::size_t joint, const Vector3& speed,
                        bool settles);
    static RowState After(const JointRows::Law& law, RowState state, float32 impulse,
                          float32 speed);
    Vector3 Beyond(std::size_t joint, const JointRows& now, const SolverContext& context) const;
    void AddTotals();
    void AddTotals(std::size_t joint);

    // JointClosing.cpp
    /// Returns the part of a row's error that velocities leave: of what is beyond a limit, all.
    static float32 RemainingOf(const JointRows& rows, int32 row)
    {
        return row < rows.Rigid() ? RemainingError(rows.error[row]) : rows.error[row];
    }
    struct Carrier
    {
        int32 body;     // solver index
        SolverBody end; // of the drift
    };
    int32 Cycles(int32 part, float32 timeStep) const;
    void DriftInCycles(int32 part, int32 count, const SolverContext& context, float32 timeStep,
                       const BodyKick* kicks);
    void FindCarriers(int32 part, const SolverContext& context);
    void PlaceCarriers(const SolverContext& context, float32 before);
    void KickPart(int32 part, const SolverContext& context, float32 time, const BodyKick* kicks);
    void ForgetImpulses(int32 part);
    const JointRows& FillHere(std::size_t joint, const SolverContext& context, bool torn);
    void MeetKick(int32 part, const SolverContext& context);
    void NoteKick(std::size_t joint);
    void ClosePart(int32 part, const SolverContext& context, float32 timeStep);
    bool Close(int32 part, const SolverContext& context, float32 timeStep);
    bool DrawTogether(int32 part, const SolverContext& context, float32 timeStep);
    bool HasGained(int32 part, const SolverContext& context, float32 timeStep) const;
    void ClosePoses(int32 part, const SolverContext& context);
    struct Gaps
    {
        float32 rigid = 0.0f, widest = 0.0f; ///< of rigid rows, and of all [m], [rad]

        /// Limits count only where rigid rows are closed.
        bool AreCloserThan(const Gaps& other) const
        {
            return rigid < kNearlyClosed && other.rigid < kNearlyClosed ? widest < other.widest
                                                                        : rigid < other.rigid;
        }
    };
    Gaps WantClosedPoses(int32 part, const SolverContext& context);
    double AngleOfDrift(int32 part, const SolverContext& context, float32 timeStep) const;
    bool HasMoved(int32 part, const SolverContext& context) const;
    template <class Fate>
    bool HoldStopped(int32 part, Fate&& fate);
    void LetGo(int32 part);
    float32 WantClosed(std::size_t joint, const SolverContext& context, float32 timeStep);

    bool IsAtRisk(int32 part) const;
    void HoldTorn(int32 part);
    JointRows OwnRows(std::size_t joint) const;
    void BeginParts(const SolverContext& context, float32 share, float32 lastInverseStep,
                    const BodyKick* kicks);
    void Start(const SolverContext& context, std::size_t joint, float32 share);
    bool HasSameSides() const;
    Impulses GapsOf(b2Joint& joint, const SolverContext& context);
    void FollowOpen(const ConstraintGraph& graph, const SolverContext& context);
    void BuildTrees();
    void BeginPart(int32 part, const SolverContext& context, const BodyKick* kicks);
    void TakeImpulses(std::size_t joint);
    void TakeFrequencies();
    double ComplianceOf(int32 part) const;
    void Factor(int32 part, double compliance);
    void SolvePart(int32 part, const SolverContext& context);

    /// A body that an impact has stopped counts as this many times heavier than the rest of its
    /// component, so joints move it by a twentieth of a gap. With 200 a heavy body goes 0.49 m
    /// beyond a wall (docs/notes/tuned-constants.md).
    static constexpr double kHeldShare = 20.0;

    Array<b2Joint*> m_joints;
    Array<RowSides> m_sides;
    RowSystem m_system;
    Array<Part> m_parts;              // components of the system
    Array<HingeTree> m_trees;         // trees among them, and memory for more
    Array<int32> m_treeOf;            // per component, -1: none
    Array<Solution> m_solutions;      // per joint, in this step
    Array<std::size_t> m_rowed;       // directly solved joints, in this step
    Array<b2Joint*> m_iteratedJoints; // in this step
    JointSchedule m_iterated;
    ThreadPool* m_threads = nullptr; // of the step
    Array<uint8> m_hasBounded;       // per joint
    Array<RowStates> m_states;       // per joint
    Array<Totals> m_totals;          // per joint
    Array<Impulses> m_kicks;         // per joint: impulses before it was closed
    Array<SolverBody> m_poses;       // by index: before the drift
    Array<Carrier> m_carriers;       // of infinite mass, of one part
    Array<SolverBody> m_opened;      // by index: before joints were closed
    Array<Impulses> m_left;          // per joint: the error that may remain
    Array<b2Joint*> m_noted;         // scratch of FollowOpen: the joints
    Array<Impulses> m_notedGaps;     // and the errors before
    Array<Vector3> m_speeds;         // scratch: per joint
    JointRows m_now;                 // scratch
    Elimination m_elimination;       // scratch of Update, reused as joints wake and sleep
    Array<b2Joint*> m_partJoints;    // scratch: of one component
    bool m_begins = false;           // until the first kick of a step:
    float32 m_lastInverseStep = 0.0f, m_share = 0.0f;
    int32 m_version = -1;
    std::uint32_t m_awakeVersion = 0;
    Array<RowStates> m_restored;  // from a snapshot, for the joint list of
    int32 m_restoredVersion = -1; // this version, used by Update
};

/// True if a body of the component was stopped. Stopped and supported bodies get added mass. False
/// if a listener has put one to sleep, which must not move: its gaps close in later steps.
template <class Fate>
bool JointSystem::HoldStopped(int32 part, Fate&& fate)
{
    double mass = 0.0;
    bool any = false;
    bool isAwake = true;
    m_system.ForBodies(part, [&](const BodyData& body, std::size_t) {
        mass += 1.0 / double(body.SolverInvMass());
        any = any || fate(body) == AfterImpact::Stopped;
        isAwake = isAwake && body.awakeIndex != -1;
    });
    any = any && isAwake;
    if (any)
    {
        m_system.ForBodies(part, [&](const BodyData& body, std::size_t place) {
            const double held = fate(body) == AfterImpact::Free ? mass : kHeldShare * mass;
            const double reach = double(body.maxExtent);
            m_system.SetAddedMass(place, held, held * reach * reach);
        });
    }
    return any;
}

} // namespace box2d
