// SPDX-License-Identifier: MIT
#pragma once

#include "BodyKick.h"

class b2Joint;
class b2RevoluteJoint;

/// Bodies that nothing but hinges holds together, without loops: pendulums, chains, trees that may
/// be tied down once. What a JointSystem does with any rows is done here with the hinges' own
/// numbers, at a tenth of the cost: a body with its subtree acts on its hinge like
/// a mass that differs by direction, a matrix of 2 x 2, and these are gathered from the tips to the
/// root (the articulated-body algorithm: Featherstone, "Rigid Body Dynamics Algorithms", 2008,
/// chapter 7). A hinge's lever t is its arm turned by a quarter: a point at it moves with v - w t.
namespace box2d
{

class HingeTree
{
public:
    /// False when the joints are not a tree of plain hinges; then there is nothing to be used.
    bool Build(const Array<b2Joint*>& joints);

    /// At the start of a step; the kicks by awake body. False when the tree cannot be used in it,
    /// because motors, limits, moving platforms or bodies without mass take part.
    bool Begin(const SolverContext& context, const BodyKick* kicks);
    /// All of the step, in as many small ones or more, and leaves the sums of the impulses in the
    /// joints.
    void Step(float32 timeStep, int32 smallSteps);

    template <class Function>
    void ForBodies(Function&& function) const
    {
        for (const Link& link : m_links)
        {
            function(*link.body);
        }
    }

private:
    // In double precision: 1000 kg at the end of a chain cost more digits than a float has.
    struct Pair
    {
        double x = 0.0, y = 0.0;
    };
    /// About a point: the matrix (m11 m12 x; m12 m22 y; x y turning).
    struct Inertia
    {
        double m11, m12, m22, x, y, turning;
    };
    /// A body, and the hinge that connects it to its parent.
    struct Link
    {
        // While the joints stay the same.
        const BodyData* body = nullptr;
        const BodyData* above = nullptr; ///< its parent, nullptr: none
        b2RevoluteJoint* joint = nullptr;
        int32 parent = -1;        ///< place, -1: nothing that moves
        float32 direction = 1.0f; ///< of its impulses: -1 when it is the joint's first body

        // In a step.
        SolverBody* state = nullptr;
        BodyKick kick;
        const SolverBody* aboveState = nullptr;
        double mass = 0.0, turning = 0.0;
        b2Vec2 arm, aboveArm; ///< to the hinge, in the axes of the world at the start
        b2Vec2 offset;        ///< of the centres of mass, from above
        Pair total, noted;    ///< impulse
        SolverBody start;     ///< as the step found it
        SolverBody opened;    ///< before its hinge was closed after a drift
        Pair totalBefore;

        // At a pose.
        Pair lever, aboveLever;
        b2Vec2 open;          ///< of the hinge [m]
        Inertia inertia;      ///< of the body and all below, about its centre of mass
        double k11, k12, k22; ///< its mass at the hinge, and
        Pair turn;            ///< how much it turns when that moves,
        double ease;          ///< or when it is turned

        // Of a solution.
        Pair lack;              ///< of the hinge's speed
        Pair given;             ///< to the body from below: impulse, and
        double givenTurn = 0.0; ///< its moment
        double load = 0.0;      ///< the mass of its subtree
        double pull = 0.0;      ///< what turns the body back [N m]
        Pair change;            ///< of velocity
        double changeTurn = 0.0;
        Pair impulse; ///< in the hinge
    };

    /// A joint at one of its bodies.
    struct JointEnd
    {
        const BodyData* body;
        b2Joint* joint;
        std::size_t order; ///< of the joint

        static bool ByBodyAndOrder(const JointEnd& a, const JointEnd& b);
        static bool ByBody(const JointEnd& a, const JointEnd& b);
    };

    void AddLink(b2Joint& joint, const BodyData& above, int32 parent);
    double LastStrain(double time);
    struct Outcome
    {
        double squaredFrequency = 0.0; ///< the largest that came up [1/s^2]
        bool won = false;              ///< energy out of nothing
    };
    /// Of all bodies in a step [J].
    struct Energy
    {
        double now = 0.0;   ///< kinetic, at its end
        double due = 0.0;   ///< what it should be, of that at its start and of the kicks' work
        double moved = 0.0; ///< the sum of the amounts of these
    };
    void CloseWholly(float32 timeStep);
    void StepSafely(int32 count, float32 timeStep);
    void GoBack();
    Outcome StepIn(int32 count, float32 timeStep, bool byImpulses);
    Energy WonEnergy() const;
    void TakeWonEnergy();
    float32 WidestGap() const;
    void Kick(float32 time);
    double Strain(double time);
    void Prepare();
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
    void Factor();
    template <class Want>
    void Gather(Want&& want);
    template <class Take>
    void Spread(Take&& take);
    void ForgetGiven();
    bool CloseByImpulses(float32 timeStep);
    void ClosePoses(float32 timeStep);

    Array<Link> m_links;      ///< parents first
    Array<JointEnd> m_ends;   ///< scratch of Build
    bool m_stiffened = false; ///< bodies turn as if they were heavier than they are
};

} // namespace box2d
