// SPDX-License-Identifier: MIT
#include "JointEnergy.h"

#include "../State/Solver.h"
#include "../State/World.h"

#include <Box2D/Dynamics/Joints/b2DistanceJoint.h>
#include <Box2D/Dynamics/Joints/b2MotorJoint.h>
#include <Box2D/Dynamics/Joints/b2MouseJoint.h>
#include <Box2D/Dynamics/Joints/b2PrismaticJoint.h>
#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>
#include <Box2D/Dynamics/Joints/b2WeldJoint.h>
#include <Box2D/Dynamics/Joints/b2WheelJoint.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <cmath>

namespace box2d
{

namespace
{

/// A joint's two bodies with their displacements in the step.
class Pair
{
public:
    Pair(const b2Joint& joint, const SolverBody* bodies)
        : dataA(Data(*joint.GetBodyA())), dataB(Data(*joint.GetBodyB()))
    {
        if (bodies != nullptr)
        {
            a = bodies[dataA.SolverIndex()];
            b = bodies[dataB.SolverIndex()];
        }
    }

    b2Vec2 ArmA(const b2Vec2& local) const { return Arm(dataA, a, local); }
    b2Vec2 ArmB(const b2Vec2& local) const { return Arm(dataB, b, local); }
    b2Vec2 Offset() const { return CenterOffset(dataA, dataB) + b.d - a.d; }
    double Angle() const
    {
        return dataB.pose.angle - dataA.pose.angle + double(b.angle) - double(a.angle);
    }
    /// Returns the response of the speed along a direction to an impulse.
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
    SolverBody a, b;

private:
    static b2Vec2 Arm(const BodyData& data, const SolverBody& body, const b2Vec2& local)
    {
        return b2Mul(body.q, b2Mul(data.rotation, local - data.localCenter));
    }
};

/// Returns the stiffness of an oscillator with that frequency.
double Stiffness(double inverseMass, float32 hz)
{
    const double omega = 2.0 * double(b2_pi) * double(hz);
    return inverseMass > 0.0 ? omega * omega / inverseMass : 0.0;
}

SpringState StateOf(const b2DistanceJoint& joint, const Pair& pair)
{
    const b2Vec2 armA = pair.ArmA(joint.GetLocalAnchorA());
    const b2Vec2 armB = pair.ArmB(joint.GetLocalAnchorB());
    b2Vec2 axis = pair.Offset() + armB - armA;
    SpringState spring;
    spring.error = double(axis.Normalize() - joint.GetLength());
    spring.stiffness = Stiffness(pair.InverseMass(armA, armB, axis), joint.GetFrequency());
    return spring;
}

SpringState StateOf(const b2WheelJoint& joint, const Pair& pair)
{
    const b2Vec2 armB = pair.ArmB(joint.GetLocalAnchorB());
    const b2Vec2 reachA = pair.Offset() + armB;
    const b2Vec2 axis = b2Mul(pair.a.q, b2Mul(pair.dataA.rotation, joint.GetLocalAxisA()));
    SpringState spring;
    spring.error = double(b2Dot(axis, reachA - pair.ArmA(joint.GetLocalAnchorA())));
    spring.stiffness =
        Stiffness(pair.InverseMass(reachA, armB, axis), joint.GetSpringFrequencyHz());
    return spring;
}

SpringState StateOf(const b2WeldJoint& joint, const Pair& pair)
{
    SpringState spring;
    spring.error = pair.Angle() - double(joint.GetReferenceAngle());
    spring.stiffness =
        Stiffness(double(pair.dataA.SolverInvInertia()) + double(pair.dataB.SolverInvInertia()),
                  joint.GetFrequency());
    return spring;
}

SpringState StateOf(const b2MouseJoint& joint, const Pair& pair)
{
    const b2Vec2 arm = pair.ArmB(joint.GetBodyB()->GetLocalPoint(joint.GetAnchorB()));
    const b2Vec2 target = joint.GetTarget();
    const Pose& pose = pair.dataB.pose;
    const b2Vec2 apart(float32(pose.x - double(target.x)), float32(pose.y - double(target.y)));
    SpringState spring;
    spring.error = double((apart + pair.b.d + arm).Length());
    spring.stiffness = Stiffness(double(pair.dataB.SolverInvMass()), joint.GetFrequency());
    spring.most = double(joint.GetMaxForce());
    return spring;
}

/// Returns the maximum power: the motor corrects a fraction of its error per sub-step.
double MostPower(const b2MotorJoint& joint, const Pair& pair, double smallStep)
{
    const b2Vec2 armA = pair.ArmA(joint.GetLinearOffset());
    const b2Vec2 armB = pair.ArmB(b2Vec2_zero);
    const double rate = double(joint.GetCorrectionFactor()) / smallStep;
    const double way = double((pair.Offset() + armB - armA).Length());
    const double turn = std::abs(pair.Angle() - double(joint.GetAngularOffset()));
    const double speed = double(pair.SpeedAt(armA, armB).Length());
    const double spin = double(b2Abs(pair.b.w - pair.a.w));
    return double(joint.GetMaxForce()) * std::min(speed, rate * way) +
           double(joint.GetMaxTorque()) * std::min(spin, rate * turn);
}

bool HoldsAlongALine(const b2Joint& joint)
{
    const b2JointType type = joint.GetType();
    return type == e_distanceJoint || type == e_ropeJoint || type == e_pulleyJoint;
}

/// True if a point is further than `radii` radii of gyration from the centre of mass.
bool IsFarOut(const b2Body& body, const b2Vec2& point, float32 radii)
{
    const BodyData& data = Data(body);
    const float32 squared = (point - data.worldCenter).LengthSquared();
    return data.SolverInvInertia() * squared > radii * radii * data.SolverInvMass();
}

template <class Joint>
const Joint& As(const b2Joint& joint)
{
    return static_cast<const Joint&>(joint);
}

} // namespace

double SpringState::EnergyAt(double x) const
{
    const double pull = stiffness * std::abs(x);
    return pull <= most ? 0.5 * pull * std::abs(x)
                        : most * std::abs(x) - 0.5 * most * most / stiffness;
}

double StoredBetween(const SpringState& before, const SpringState& after)
{
    return std::min(after.EnergyAt(after.error) - after.EnergyAt(before.error),
                    before.EnergyAt(after.error) - before.EnergyAt(before.error));
}

bool IsAtRisk(const b2Joint& joint)
{
    constexpr float32 kMostRatio = 10.0f; // of masses
    constexpr float32 kLongLever = 4.0f;  // in radii of gyration
    // Tension along a line rotates a body within a sub-step, which the estimate does not include.
    constexpr float32 kLongLeverOfLine = 2.0f;
    const BodyData& a = Data(*joint.GetBodyA());
    const BodyData& b = Data(*joint.GetBodyB());
    const float32 mA = a.SolverInvMass();
    const float32 mB = b.SolverInvMass();
    if (mA > 0.0f && mB > 0.0f && (mA > kMostRatio * mB || mB > kMostRatio * mA))
    {
        return true;
    }
    const float32 most = HoldsAlongALine(joint) ? kLongLeverOfLine : kLongLever;
    return HasLeverOnB(joint, most) || HasLeverOnA(joint, most);
}

bool HasLeverOnA(const b2Joint& joint, float32 radii)
{
    // The forces on A act at B's anchor, which may be far from A.
    return joint.GetType() != e_mouseJoint &&
           IsFarOut(*joint.GetBodyA(),
                    HasChangingLevers(joint) ? joint.GetAnchorB() : joint.GetAnchorA(), radii);
}

bool HasLeverOnB(const b2Joint& joint, float32 radii)
{
    return IsFarOut(*joint.GetBodyB(), joint.GetAnchorB(), radii);
}

bool HasChangingLevers(const b2Joint& joint)
{
    const b2JointType type = joint.GetType();
    return type == e_prismaticJoint || type == e_wheelJoint || type == e_motorJoint;
}

bool HasSpring(const b2Joint& joint)
{
    switch (joint.GetType())
    {
    case e_distanceJoint:
        return As<b2DistanceJoint>(joint).IsSpring();
    case e_wheelJoint:
        return As<b2WheelJoint>(joint).GetSpringFrequencyHz() > 0.0f;
    case e_weldJoint:
        return As<b2WeldJoint>(joint).GetFrequency() > 0.0f;
    case e_mouseJoint:
        return true;
    default:
        return false;
    }
}

SpringState SpringOf(const b2Joint& joint, const SolverBody* bodies)
{
    const Pair pair(joint, bodies);
    switch (joint.GetType())
    {
    case e_distanceJoint:
        return StateOf(As<b2DistanceJoint>(joint), pair);
    case e_wheelJoint:
        return StateOf(As<b2WheelJoint>(joint), pair);
    case e_weldJoint:
        return StateOf(As<b2WeldJoint>(joint), pair);
    case e_mouseJoint:
        return StateOf(As<b2MouseJoint>(joint), pair);
    default:
        return SpringState();
    }
}

bool HasMotor(const b2Joint& joint)
{
    switch (joint.GetType())
    {
    case e_revoluteJoint:
        return As<b2RevoluteJoint>(joint).IsMotorEnabled();
    case e_prismaticJoint:
        return As<b2PrismaticJoint>(joint).IsMotorEnabled();
    case e_wheelJoint:
        return As<b2WheelJoint>(joint).IsMotorEnabled();
    case e_motorJoint:
        return true;
    default:
        return false;
    }
}

double MostMotorWork(const b2Joint& joint, const SolverBody* bodies, float32 timeStep,
                     int32 subSteps)
{
    const auto work = [timeStep](float32 speed, float32 most) {
        return double(timeStep) * double(b2Abs(speed)) * double(most);
    };
    switch (joint.GetType())
    {
    case e_revoluteJoint: {
        const auto& j = As<b2RevoluteJoint>(joint);
        return work(j.GetMotorSpeed(), j.GetMaxMotorTorque());
    }
    case e_prismaticJoint: {
        const auto& j = As<b2PrismaticJoint>(joint);
        return work(j.GetMotorSpeed(), j.GetMaxMotorForce());
    }
    case e_wheelJoint: {
        const auto& j = As<b2WheelJoint>(joint);
        return work(j.GetMotorSpeed(), j.GetMaxMotorTorque());
    }
    case e_motorJoint:
        return double(timeStep) * MostPower(As<b2MotorJoint>(joint), Pair(joint, bodies),
                                            double(timeStep) / double(subSteps));
    default:
        return 0.0;
    }
}

} // namespace box2d
