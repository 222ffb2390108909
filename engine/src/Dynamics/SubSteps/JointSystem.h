// SPDX-License-Identifier: MIT
#pragma once

#include "../Direct/BoundedSystem.h"
#include "HingeTree.h"

#include <cmath>

/// All that joints do in sub-steps. What they hold rigidly is a RowSystem. Motors and limits
/// take part in it as long as their forces do what they should; which do is found by trying (block
/// pivoting: Judice and Pires, "A block principal pivoting algorithm for large-scale strictly
/// monotone linear complementarity problems", 1994). A component with too many loops is iterated
/// over.
namespace box2d
{

struct SnapshotAccess;

class ConstraintGraph;

/// What impacts within a step have made of a body.
enum class AfterImpact : uint8
{
    Free,
    Leans,   ///< on what does not move: drawn into that it would have to be pushed out again
    Stopped, ///< it has come elsewhere than the step had brought it
};

class JointSystem
{
public:
    /// Follows the graph's list of joints; costs nothing while that stays the same.
    void Update(const ConstraintGraph& graph);
    bool IsEmpty() const { return m_joints.empty(); }
    /// One call of SolveVelocities is enough.
    bool IsExact() const { return m_system.IsExact(); }
    bool IsExact(std::size_t joint) const { return m_system.IsExact(joint); }
    std::size_t Count() const { return m_joints.size(); }
    b2Joint& At(std::size_t joint) const { return *m_joints[joint]; }
    const RowSides& Sides(std::size_t joint) const { return m_sides[joint]; }

    /// At the start of a step: takes up the impulses that the joints were left with, times `share`.
    /// `lastInverseStep`: one over its length.
    void Begin(const SolverContext& context, float32 share, float32 lastInverseStep,
               const BodyKick* kicks);
    /// What goes through the step by itself, in StepTrees; all else leaves it alone.
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
    /// Whether there is anything else.
    bool HasRows() const { return !m_rowed.empty(); }
    void StepTrees(float32 timeStep, int32 smallSteps);
    /// At the present poses and the velocities before a kick: the rows. The context's step is the
    /// kick's, its inverse that of the drift that follows.
    void Prepare(const SolverContext& context);
    /// After the bodies have been kicked: applies the last impulses, times `share`.
    void WarmStart(const SolverContext& context, float32 share);
    /// The same for joints of which `which`, a function of their sides, is true, from nothing.
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
    /// Of all that is not in a tree, with its number.
    template <class Function>
    void ForRowed(Function&& function) const
    {
        for (const std::size_t i : m_rowed)
        {
            function(i, m_system.Rows(i));
        }
    }
    /// What motors, springs and limits of a joint can have done at most by the impulses of a kick:
    /// an impulse is given to something that is slower than wanted, and does no more work than by
    /// the mean of the speeds before and after [J]. A spring may want thousands of metres a second.
    double MostWork(std::size_t joint, const SolverContext& before,
                    const SolverContext& after) const;
    /// Makes the speeds of all rows what they should be; what no contact touches, the first time.
    void SolveVelocities(const SolverContext& context, bool first);
    /// Before a drift.
    void NotePoses(const SolverContext& context);
    /// After the bodies have moved for `timeStep`: impulses along the rows of Prepare, which change
    /// velocities and with them the way, close the joints. (RATTLE: Andersen, "Rattle: a
    /// 'velocity' version of the Shake algorithm", 1983.)
    /// The kicks: by awake body.
    void SolvePositions(const SolverContext& context, float32 timeStep, int32 sweeps,
                        const BodyKick* kicks);
    /// After contacts have pushed what overlaps apart, since SolvePositions: takes back what that
    /// has opened of the joints.
    void CloseAfterPushes(const SolverContext& context);
    /// When all is written back, before an impact within the step: how far joints are open.
    void NoteOpen(const ConstraintGraph& graph, const SolverContext& context);
    /// After impacts within the step, which have moved some bodies by themselves: the parts of
    /// those whose `fate` says so are closed, for which the context's bodies, in which nothing
    /// has moved yet, get ways. Calls `changed` with each of these parts.
    template <class Fate, class Changed>
    void CloseAfterImpacts(const ConstraintGraph& graph, const SolverContext& context, Fate&& fate,
                           Changed&& changed)
    {
        Update(graph);
        for (int32 i = 0; i < m_system.Components(); ++i)
        {
            if (!HoldStopped(i, fate))
            {
                continue;
            }
            ClosePoses(i, context);
            LetGo(i);
            changed(i);
        }
    }
    // Of a part.
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
    /// Leaves the sums of the step's impulses in the joints.
    void End();

    /// A joint as part of a larger system: after SolveVelocities its rows, and when that is solved
    /// the impulses that it took.
    void FillItem(std::size_t joint, JointRows& rows, BoundedSystem::Item& item) const;
    void TakeItem(std::size_t joint, const BoundedSystem::Item& item);
    /// The same where ways take the place of velocities: what is rigid and what is at a limit stays
    /// where it is, but motors and springs ask for velocities, not for ways.
    void FillWays(std::size_t joint, JointRows& rows, BoundedSystem::Item& item) const;

private:
    friend struct SnapshotAccess;
    struct Impulses
    {
        float32 at[JointRows::kMostRows];
    };
    /// What a row that gives way does.
    enum class Yield : uint8
    {
        Holds,   ///< its speed is as wanted
        Most,    ///< its impulse is as large as it can be, or
        Least,   ///< as small
        Slowest, ///< its speed is at a bound, whatever impulse that takes
        Fastest,
    };
    struct Yields
    {
        Yield of[JointRows::kMostRows] = {};
    };
    /// Of the kicks of a step.
    struct Totals
    {
        float32 within[JointRows::kMostRows] = {};
        float32 beyond[JointRows::kMostRows] = {};
    };
    /// A connected component.
    struct Part
    {
        bool touched = false; ///< by contacts
        bool gives = false;   ///< some row of it
        bool driven = false;  ///< some row of it, and not at a limit alone
        bool lines = false;   ///< ropes and rods
        bool damped = false;
        bool factored = false;
        HingeTree* tree = nullptr;     ///< that does it all in this step
        double squaredFrequency = 0.0; ///< see RowSystem, of the last step's mean forces
    };

    // JointYield.cpp
    static void Validate(const JointRows& rows, Yields& yields);
    float32 CarriedOver(std::size_t joint, int32 row, float32 share) const;
    static double WantedSpeed(const JointRows& rows, Yield yield, int32 row, double impulse);
    void SetActive(std::size_t joint);
    bool SetActiveToClose(std::size_t joint);
    void WantSpeeds(std::size_t joint, const SolverContext& context);
    bool Reconsider(std::size_t joint, const SolverContext& context, bool settles);
    bool Reconsider(const SolverContext& context, std::size_t joint, int32 row, float32 speed,
                    bool settles);
    bool ReconsiderDisc(const SolverContext& context, std::size_t joint, const Vector3& speed,
                        bool settles);
    static Yield After(const JointRows::Law& law, Yield yield, float32 impulse, float32 speed);
    Vector3 Beyond(std::size_t joint, const JointRows& now, float32 timeStep) const;
    void AddTotals();
    void AddTotals(std::size_t joint);

    // JointClosing.cpp
    int32 Cycles(int32 part, float32 timeStep) const;
    void DriftInCycles(int32 part, int32 count, const SolverContext& context, float32 timeStep,
                       const BodyKick* kicks);
    void KickPart(int32 part, const SolverContext& context, float32 time, const BodyKick* kicks);
    void ForgetImpulses(int32 part);
    const JointRows& FillHere(std::size_t joint, const SolverContext& context);
    void MeetKick(int32 part, const SolverContext& context);
    void NoteKick(std::size_t joint);
    void ClosePart(int32 part, const SolverContext& context, float32 timeStep);
    bool Close(int32 part, const SolverContext& context, float32 timeStep);
    void DrawTogether(int32 part, const SolverContext& context, float32 timeStep);
    bool HasGained(int32 part, const SolverContext& context, float32 timeStep) const;
    void ClosePoses(int32 part, const SolverContext& context);
    float32 WantClosedPoses(int32 part, const SolverContext& context);
    void ShortenPushes(int32 part, const SolverContext& context);
    bool HasMoved(int32 part, const SolverContext& context) const;
    template <class Fate>
    bool HoldStopped(int32 part, Fate&& fate);
    void LetGo(int32 part);
    void CloseSwept(const SolverContext& context, float32 timeStep, int32 sweeps);
    float32 SweepClosed(const SolverContext& context, float32 timeStep, int32 sweeps);
    float32 WantClosed(std::size_t joint, const SolverContext& context, float32 timeStep,
                       float32 lasting);

    void Start(const SolverContext& context, std::size_t joint, float32 share);
    void BuildTrees();
    void BeginPart(int32 part, const SolverContext& context, const BodyKick* kicks);
    void TakeImpulses(std::size_t joint);
    double ComplianceOf(int32 part) const;
    void SolvePart(int32 part, const SolverContext& context);
    void Lack(std::size_t joint, const SolverContext& context, const Vector3& wanted);

    /// How many times as heavy a body that an impact has stopped counts as the rest of its
    /// component.
    static constexpr double kHeldShare = 20.0;
    /// But its turn only up to this angle [rad]: an impact, which does not know what hangs on a
    /// light body, may throw it into a spin that its joints would never have let it have.
    static constexpr double kMostHeldTurn = 0.5;

    Array<b2Joint*> m_joints;
    Array<RowSides> m_sides;
    RowSystem m_system;
    Array<Part> m_parts;        // the system's components
    Array<HingeTree> m_trees;   // those among them, and memory for more
    Array<int32> m_treeOf;      // of each part, -1: none
    Array<uint8> m_inTree;      // of each joint, in this step
    Array<std::size_t> m_rowed; // joints that are not in a tree, in this step
    Array<uint8> m_gives;       // of each joint
    Array<Yields> m_yields;     // of each joint
    Array<Totals> m_totals;     // of each joint
    Array<Impulses> m_kicks;    // each joint's impulses before it was closed
    Array<SolverBody> m_poses;  // by place: before the drift
    Array<SolverBody> m_opened; // by place: before joints were closed
    Array<Impulses> m_left;     // of each joint's errors: how far it may stay open
    Array<SolverBody> m_before; // of swept joints' bodies: the same
    Array<Vector3> m_speeds;    // scratch: of each joint's rows
    Array<const BodyData*> m_sweptBodies;
    JointRows m_now;              // scratch
    Elimination m_elimination;    // scratch of Update, as joints wake and sleep
    Array<b2Joint*> m_partJoints; // the same: of one part
    int32 m_version = -1;
    Array<Yields> m_restored;     // from a snapshot: those of the list of
    int32 m_restoredVersion = -1; // this version, for Update to go on with
};

/// Whether a body of the part was stopped; such ones, and what leans on something, are made hard to
/// move. Not where a listener has put one to sleep, which is not to be moved: what is open there
/// closes in later steps.
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
            const double turn = std::abs(body.pose.angle - body.previous.angle);
            const double reach = double(body.maxExtent);
            m_system.SetBallast(place, held, (turn > kMostHeldTurn ? mass : held) * reach * reach);
        });
    }
    return any;
}

} // namespace box2d
