// SPDX-License-Identifier: MIT
#pragma once

#include "../Joints/JointEnergy.h"
#include "../State/Solver.h"

/// The last resort of a step: what hangs together by joints keeps no energy that nothing gave it.
/// Sweeps that have not converged, corrections of poses, and impacts within a step, in which joints
/// have no part, can win some, and light bodies on long levers win without end.
///
/// An account is kept island by island: kinetic energy, the work of gravity and forces along the
/// ways that bodies really went, what springs store; motors may give what they can at most. All
/// else only takes. What an island wins it owes. A little of that is truncation, and goes up and
/// down. More is taken away: corrections of poses when they have wound up springs, all of the way
/// when velocities that cannot be paid for have; then velocity, at first what there is of it within
/// the island, which leaves the momentum as it is. What was won long ago is taken back slowly.
/// What was lost counts as credit: a loaded chain of joints that sweeps do not hold rigidly gives
/// back what stopping it took, and joints that were pulled open lift their bodies when they close.
/// Bodies carry their island's account in shares, so that islands may merge and come apart.
///
/// Where everything is as it should be nothing is changed, not a bit. Only islands with joints that
/// are at risk (IsAtRisk) have accounts; what a platform, a conveyor belt or a restitution above 1
/// drives is not taken from, nor is what the program moves by hand: SetTransform of a body that
/// belongs to it, holds it or touches it, limits, lengths and ratios of its joints.
namespace box2d
{

struct SnapshotAccess;

class ConstraintGraph;
struct SolverMemory;
class World;

class EnergyGuard
{
public:
    /// Before anything is solved: the bodies' velocities are those of the start, with or without
    /// the first kick.
    void Begin(const World& world, const SolverMemory& solver, float32 timeStep);
    /// Velocities and ways being final, before they are written back.
    void Balance(const World& world, SolverMemory& solver);
    bool HasAccounts() const { return !m_accounts.empty(); }
    /// The end of a body's step.
    struct Way
    {
        Pose end;
        b2Vec2 v;
        float32 w;
    };
    /// After an impact within the step has changed it. In one step a body that is taken back to
    /// where it met another keeps the speed of its whole fall.
    void NoteImpact(BodyData& body, const Way& before) const;
    /// After impacts: what they have brought into springs is owed in the next step.
    void ChargeImpacts();

private:
    friend struct SnapshotAccess;
    struct Spring
    {
        b2Joint* joint;
        int32 account;
        SpringState before, after; ///< the step
    };
    struct Motor
    {
        const b2Joint* joint;
        int32 account;
        double work; ///< at most, as it looks at the start of the step [J]
    };
    /// Of an island.
    struct Account
    {
        int32 island = -1;
        double owed = 0.0;  ///< negative: credit [J]
        double past = 0.0;  ///< the largest kinetic energy of late, before the step [J]
        double scale = 0.0; ///< the same after it
    };

    int32 AccountOf(const BodyData& body) const;
    void FindRisks(const ConstraintGraph& graph);
    void Open(const b2Joint& joint);
    int32 AccountOf(const b2Joint& joint) const;
    double Won(const BodyData& body, const SolverBody& after) const;
    float32 PastOf(const BodyData& body) const;
    void AddBodies(const World& world, SolverMemory& solver);
    void AddJoints(const World& world, const SolverMemory& solver);
    void Collect(const World& world, SolverMemory& solver, Account& account);
    void MoveAgain(const b2Body& first, SolverMemory& solver, Account& account, float32 time);
    void ShareOut(const World& world, const SolverMemory& solver);

    Array<const b2Joint*> m_risky;   // whose islands have accounts
    Array<const b2Joint*> m_sliding; // that may become so at any time
    int32 m_version = -1;            // of the graph's list
    Array<int32> m_accountOf;        // by island; -1: none, as of all that m_accounts does not name
    Array<Account> m_accounts;
    Array<Spring> m_springs;
    Array<Motor> m_motors;
    b2Vec2 m_gravity;
    float32 m_leastFall = 0.0f; // [J/kg]
    float32 m_timeStep = 0.0f;
    int32 m_subSteps = 1;
};

} // namespace box2d
