// SPDX-License-Identifier: MIT
#pragma once

#include "../State/BodyPose.h"
#include "../State/Solver.h"

#include <Box2D/Dynamics/Joints/b2Joint.h>
#include <Box2D/Dynamics/b2Body.h>

#include <limits>

/// The energy that a joint stores and may give in a step. It follows from the joint's settings and
/// the poses of its bodies, not from the impulses of a solver.
namespace box2d
{

/// A spring that pulls back with k x, limited to `maximum`.
struct SpringState
{
    double stiffness = 0.0; ///< k [N/m] or [N m], of the present pose
    double error = 0.0;     ///< x [m] or [rad]
    double maximum = std::numeric_limits<double>::infinity(); ///< [N] or [N m]

    double Energy() const { return EnergyAt(error); }
    /// Returns k x^2 / 2, and a linear function beyond `maximum` / k [J].
    double EnergyAt(double x) const;
};

/// The two bodies of a joint after their motion in the step. Temporary, never stored.
class JointPair
{
public:
    /// `bodies` by solver index; null: before the step, at rest.
    JointPair(const b2Body& bodyA, const b2Body& bodyB, const SolverBody* bodies)
        : dataA(Data(bodyA)), dataB(Data(bodyB)), a(StateOf(dataA, bodies)),
          b(StateOf(dataB, bodies))
    {}

    /// Returns the vector from the centre of mass to a point in the body's frame, in world axes.
    b2Vec2 ArmA(const b2Vec2& local) const { return Arm(dataA, a, local); }
    b2Vec2 ArmB(const b2Vec2& local) const { return Arm(dataB, b, local); }
    /// Returns a direction that is fixed to A, in world axes.
    b2Vec2 AxisOfA(const b2Vec2& local) const { return b2Mul(a.q, b2Mul(dataA.rotation, local)); }
    /// Returns the vector from the centre of mass A to that of B.
    b2Vec2 Offset() const { return CenterOffset(dataA, dataB) + b.d - a.d; }
    /// Returns the angle of B relative to A [rad].
    double Angle() const
    {
        return dataB.pose.angle - dataA.pose.angle + double(b.angle) - double(a.angle);
    }
    /// An axis that rotates with A, and the position of B's point along it.
    struct Slide
    {
        b2Vec2 axis;
        b2Vec2 armA, armB;
        b2Vec2 reachA; ///< from the centre of mass A to B's point
        float32 translation;
    };
    Slide Along(const b2Vec2& localAxisA, const b2Vec2& localAnchorA,
                const b2Vec2& localAnchorB) const
    {
        Slide slide{AxisOfA(localAxisA), ArmA(localAnchorA), ArmB(localAnchorB), {}, 0.0f};
        slide.reachA = Offset() + slide.armB;
        slide.translation = b2Dot(slide.axis, slide.reachA - slide.armA);
        return slide;
    }
    /// Returns the change of speed along a direction per impulse along it.
    double InverseMass(const b2Vec2& armA, const b2Vec2& armB, const b2Vec2& direction) const
    {
        const auto turn = [&](const BodyData& body, const b2Vec2& arm) {
            const double lever = double(b2Cross(arm, direction));
            return double(body.SolverInvInertia()) * lever * lever;
        };
        return double(dataA.SolverInvMass()) + double(dataB.SolverInvMass()) + turn(dataA, armA) +
               turn(dataB, armB);
    }
    b2Vec2 SpeedAt(const b2Vec2& armA, const b2Vec2& armB) const
    {
        return b.v + b2Cross(b.w, armB) - a.v - b2Cross(a.w, armA);
    }

    const BodyData& dataA;
    const BodyData& dataB;
    const SolverBody& a;
    const SolverBody& b;

private:
    static const SolverBody& StateOf(const BodyData& data, const SolverBody* bodies)
    {
        static const SolverBody atRest;
        return bodies != nullptr ? bodies[data.SolverIndex()] : atRest;
    }
    static b2Vec2 Arm(const BodyData& data, const SolverBody& body, const b2Vec2& local)
    {
        return b2Mul(body.q, b2Mul(data.rotation, local - data.localCenter));
    }
};

/// Returns the stiffness of an oscillator with that frequency.
inline double StiffnessOf(double inverseMass, float32 hz)
{
    const double omega = 2.0 * double(b2_pi) * double(hz);
    return inverseMass > 0.0 ? omega * omega / inverseMass : 0.0;
}

/// Returns the energy stored in a spring from one state to another, without the part explained by a
/// changed k [J]. k belongs to an oscillator with a given frequency, so it follows the moved mass,
/// which changes with the pose. Uses the k of the state in which the result is smaller.
double StoredBetween(const SpringState& before, const SpringState& after);

/// True if iterations may add energy over the joint without bound. That is so beyond the limits the
/// manual advises: masses of 10:1, and bodies on levers much longer than they are. For a rod or a
/// rope, half of that length counts.
bool IsAtRisk(const b2Joint& joint);
/// True if two bodies that move differ in mass by more than the manual's tenfold.
bool HaveUnequalMasses(const BodyData& a, const BodyData& b);
/// True if that also depends on the pose.
bool HasChangingLevers(const b2Joint& joint);
/// True if the joint holds along a line: a rope, a rod or a pulley.
bool IsLine(const b2Joint& joint);
/// True if such a line turns so far in that time [s] that a straight move
/// no longer resembles the arc. A circle at 98 m/s on a pulley gained a quarter of its energy.
bool TurnsFar(const b2Joint& joint, float32 time);
/// True if the joint acts on the body further from its centre than `radii` radii of gyration.
bool HasLeverOnA(const b2Joint& joint, float32 radii);
bool HasLeverOnB(const b2Joint& joint, float32 radii);

bool HasSpring(const b2Joint& joint);
/// Returns the state of a joint's spring. `bodies` by solver index, with the displacements since
/// the start of the step; null without displacements.
SpringState SpringOf(const b2Joint& joint, const SolverBody* bodies);

/// True if it has a motor that is on.
bool HasMotor(const b2Joint& joint);
/// Returns the maximum work of the motor in a step, from the current state [J]. At
/// its target speed the motor does no more work.
double MaxMotorWork(const b2Joint& joint, const SolverBody* bodies, float32 timeStep);

} // namespace box2d
