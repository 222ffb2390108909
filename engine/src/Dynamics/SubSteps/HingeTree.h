// SPDX-License-Identifier: MIT
#pragma once

#include "../Solver/BodyKick.h"

class b2Joint;
class b2RevoluteJoint;

/// Bodies connected only by hinges, without loops: pendulums, chains, trees with at most one fixed
/// point. It solves what a JointSystem does for any rows, at a tenth of the cost. A body with its
/// subtree acts on its hinge like a mass that differs by direction, a matrix of 2 x 2. These are
/// gathered from the tips to the root (the articulated-body algorithm: Featherstone, "Rigid Body
/// Dynamics Algorithms", 2008, chapter 7). A hinge's lever t is its arm turned by a quarter: a
/// point at it moves with v - w t.
namespace box2d
{

class HingeTree
{
public:
    /// For connected joints that are attached to the world once at most. False if they are not a
    /// tree of plain hinges; it cannot be used then.
    bool Build(const Array<b2Joint*>& joints);

    /// Call at the start of a step; the kicks are by awake body. False if the tree cannot be used
    /// in this step, because of motors, limits, moving platforms or bodies without mass.
    bool Begin(const SolverContext& context, const BodyKick* kicks);
    /// Performs the whole step and stores the sums of the impulses in the joints. Where `subSteps`
    /// sub-steps lose energy, it takes more; where they gain energy or tear a hinge, with stiffened
    /// hinges. `lastStep` is the time of the step before [s].
    void Step(float32 timeStep, int32 subSteps, float32 lastStep);

    template <class Function>
    void ForBodies(Function&& function) const
    {
        for (const Link& link : m_links)
        {
            function(*link.body);
        }
    }

private:
    // In double precision: 1000 kg at the end of a chain exceeds the precision of float.
    struct Pair
    {
        double x = 0.0, y = 0.0;
    };
    /// Inertia about a point: the matrix (m11 m12 x; m12 m22 y; x y turning).
    struct Inertia
    {
        double m11, m12, m22, x, y, turning;
    };
    /// A body, and the hinge that connects it to its parent.
    struct Link
    {
        // Constant while the joints are unchanged.
        const BodyData* body = nullptr;
        const BodyData* above = nullptr; ///< its parent, nullptr: none
        b2RevoluteJoint* joint = nullptr;
        int32 parent = -1;        ///< index, -1: none that moves
        float32 direction = 1.0f; ///< sign of its impulses: -1 if it is the joint's first body

        // Values of a step.
        SolverBody* state = nullptr;
        BodyKick kick;
        const SolverBody* aboveState = nullptr;
        double mass = 0.0, turning = 0.0;
        b2Vec2 arm, aboveArm; ///< to the hinge, in world axes at the start
        b2Vec2 offset;        ///< between the centres of mass, from above
        Pair total, noted;    ///< impulses
        SolverBody start;     ///< at the start of the step
        SolverBody opened;    ///< before its hinge was closed after a drift
        Pair totalBefore;

        // Values of a pose.
        Pair lever, aboveLever;
        b2Vec2 open;          ///< of the hinge [m]
        Inertia inertia;      ///< of the body and all below, about its centre of mass
        double k11, k12, k22; ///< its mass matrix at the hinge [kg]
        Pair turn;            ///< change of its angular velocity per change of the hinge's [1/m]
        double ease;          ///< change of its angular velocity per angular impulse

        // Values of a solution.
        Pair residual;              ///< of the hinge's speed
        Pair given;                 ///< impulse from the subtree
        double givenTurn = 0.0;     ///< its moment
        double load = 0.0;          ///< the mass of its subtree
        double stiffness = 0.0;     ///< restoring torque of the body by its rotation [N m/rad]
        double lastStiffness = 0.0; ///< the same by the mean forces of the last step
        Pair change;                ///< of velocity
        double changeTurn = 0.0;
        Pair impulse; ///< impulse in the hinge
    };

    /// A joint, listed by one of its bodies.
    struct JointEnd
    {
        const BodyData* body;
        b2Joint* joint;
        std::size_t order; ///< index of the joint
    };

    void AddLink(b2Joint& joint, const BodyData& above, int32 parent);
    /// Energy of all bodies in a step [J].
    struct Energy
    {
        double now = 0.0; ///< kinetic, at the end
        double due = 0.0; ///< expected: at the start, plus the work of kicks
        /// Sum of the absolute values, and of what the kicks would give to bodies at rest.
        double moved = 0.0;
    };
    void CloseWholly(float32 timeStep);
    void GoBack(float32 lastStep);
    double StepIn(int32 count, float32 timeStep);
    Energy GainedEnergy() const;
    void TakeGainedEnergy();
    float32 WidestGap() const;
    void Kick(float32 time);
    void FindStiffness(double time);
    void TakeLastStiffness(double lastStep);
    void HoldStiffness();
    void TakeLevers();
    void TakeInertias();
    void Factor(Link& link);
    void Stop();
    void Close(float32 timeStep);
    void LeaveImpulses() const;
    static b2Vec2 Measure(const Link& link, b2Vec2& arm, b2Vec2& aboveArm);
    static b2Vec2 TakeLevers(Link& link);
    static void FactorAtHinge(Link& link);
    static void AddInertia(const Link& link, Inertia& parent);
    static void AddGiven(const Link& link, Link& parent);
    static void FindChange(Link& link, const Link* parent);
    static void AddVelocity(Link& link);
    static void AddPose(Link& link, float32 timeStep);
    static float32 WantClosed(Link& link, float32 timeStep);
    template <bool factors, class Want>
    void Gather(Want&& want);
    template <class Take>
    void Spread(Take&& take);
    void ForgetGiven();
    bool CloseByImpulses(float32 timeStep);
    void ClosePoses(float32 timeStep);

    Array<Link> m_links;         ///< parents first
    Array<JointEnd> m_ends;      ///< scratch of Build
    bool m_stiffened = false;    ///< bodies have added inertia
    bool m_unequal = false;      ///< masses of neighbours differ by too much to keep all energy
    float32 m_maxDamping = 0.0f; ///< [1/s]
    float32 m_timeStep = 0.0f;   ///< [s]
    float32 m_drift = 0.0f;      ///< length of a sub-step [s]
};

} // namespace box2d
