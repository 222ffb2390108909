// SPDX-License-Identifier: MIT
#pragma once

#include "../Joints/JointEnergy.h"
#include "../State/Solver.h"

/// Prevents islands with joints from gaining energy, as the last stage of a step. Iterations that
/// have not converged, pose corrections, and impacts that ignore joints can add energy, without
/// bound for light bodies on long levers.
///
/// Each island has an account. It contains the kinetic energy, the work of gravity and forces along
/// the actual paths, the energy of springs, and the maximum work of motors. Everything else only
/// dissipates. A gain is a debt of the island. A small one is truncation error, and fluctuates. A
/// larger one is removed in this order:
/// - without sub-steps, pose corrections that loaded springs;
/// - without sub-steps, the whole displacement, if velocities loaded springs that they cannot pay;
/// - velocity.
/// Relative velocity within the island is removed first, because that conserves momentum. Gains are
/// removed slowly, but for large ones in the step in which velocities gain them. Losses count as
/// credit. A loaded chain that iterations do not hold rigidly returns the energy of stopping it,
/// and opened joints lift their bodies when they close. Bodies store their island's account in
/// shares, so that islands can merge and split.
///
/// While an island's debt is at most a hundredth of its scale, no bit of its motion changes. Only
/// islands with joints at risk (IsAtRisk, TurnsFar) have accounts. Nothing is removed from islands
/// driven by a platform, a conveyor belt or a restitution above 1. The same holds for user changes:
/// SetTransform of a connected or touching body, and limits, lengths and ratios of joints.
namespace box2d
{

struct SnapshotAccess;

class ConstraintGraph;
struct SolverMemory;
class World;

class EnergyGuard
{
public:
    /// Call before the solver: velocities are those of the start of the step, with or without the
    /// first sub-step's impulse.
    void Begin(const World& world, SolverMemory& solver, float32 timeStep);
    /// Call when velocities and paths are final, before they are written back.
    void Balance(const World& world, SolverMemory& solver);
    bool HasAccounts() const { return !m_accounts.empty(); }
    /// The state of a body at the end of the step.
    struct Path
    {
        Pose end;
        b2Vec2 v;
        float32 w;
    };
    /// Call after an impact changed the body. In a step without sub-steps, a body moved back to an
    /// impact keeps the velocity of its whole fall.
    void NoteImpact(BodyData& body, const Path& before) const;
    /// Call after impacts: energy that they stored in springs is charged in the next step.
    void ChargeImpacts();

private:
    friend struct SnapshotAccess;
    struct Spring
    {
        b2Joint* joint;
        int32 account;
        SpringState before, after; ///< of the step
    };
    struct Motor
    {
        const b2Joint* joint;
        int32 account;
        double work; ///< maximum, estimated at the start of the step [J]
    };
    /// The account of an island.
    struct Account
    {
        int32 island = -1;
        double owed = 0.0;             ///< from earlier steps; negative: credit [J]
        double gained = 0.0;           ///< in this step [J]
        double gainedByVelocity = 0.0; ///< if bodies moved by their velocities alone [J]
        double past = 0.0;  ///< decaying maximum of the kinetic energy, before the step [J]
        double scale = 0.0; ///< the same after the step
        double share = 0.0; ///< what is owed after the step, as a fraction of the scale

        double Debt() const { return owed + gained; }
    };

    int32 AccountOf(const BodyData& body) const;
    void FindRisks(const ConstraintGraph& graph);
    void Open(const b2Joint& joint);
    int32 AccountOf(const b2Joint& joint) const;
    float32 WorkOfPushes(const b2Vec2& a, const SolverBody& s, const b2Vec2& pushed) const;
    double Gained(const BodyData& body, const SolverBody& after, const b2Vec2& pushed) const;
    float32 PastOf(const BodyData& body) const;
    void AddBodies(const World& world, SolverMemory& solver);
    void AddJoints(const SolverMemory& solver);
    void Collect(const World& world, SolverMemory& solver, Account& account);
    void MoveAgain(const b2Body& first, SolverMemory& solver, Account& account, float32 time);
    void ShareOut(const World& world, const SolverMemory& solver);

    Array<const b2Joint*> m_risky;    // joints at risk, whose islands have accounts
    Array<const b2Joint*> m_changing; // joints that may become so at any time
    int32 m_version = -1;             // of the graph's joint list
    Array<int32> m_accountOf;         // by island; -1: none
    Array<Account> m_accounts;
    Array<Spring> m_springs;
    Array<Motor> m_motors;
    b2Vec2 m_gravity;
    float32 m_minFall = 0.0f; // [J/kg]
    float32 m_timeStep = 0.0f;
    int32 m_subSteps = 1;
};

} // namespace box2d
