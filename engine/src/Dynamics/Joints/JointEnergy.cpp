// SPDX-License-Identifier: MIT
#include "JointEnergy.h"

#include "JointKinds.h"

#include <algorithm>
#include <cmath>

namespace box2d
{

namespace
{

/// True if a point is more than `radii` of gyration from the centre of mass.
bool IsFarOut(const b2Body& body, const b2Vec2& point, float32 radii)
{
    const BodyData& data = Data(body);
    const float32 squared = (point - data.worldCenter).LengthSquared();
    return data.SolverInvInertia() * squared > radii * radii * data.SolverInvMass();
}

} // namespace

double SpringState::EnergyAt(double x) const
{
    const double pull = stiffness * std::abs(x);
    return pull <= maximum ? 0.5 * pull * std::abs(x)
                           : maximum * std::abs(x) - 0.5 * maximum * maximum / stiffness;
}

double StoredBetween(const SpringState& before, const SpringState& after)
{
    return std::min(after.EnergyAt(after.error) - after.EnergyAt(before.error),
                    before.EnergyAt(after.error) - before.EnergyAt(before.error));
}

bool HaveUnequalMasses(const BodyData& a, const BodyData& b)
{
    // The manual's limit: "Stability degrades as the mass ratio passes 10:1".
    constexpr float32 kMaxRatio = 10.0f;
    const float32 mA = a.SolverInvMass();
    const float32 mB = b.SolverInvMass();
    return mA > 0.0f && mB > 0.0f && (mA > kMaxRatio * mB || mB > kMaxRatio * mA);
}

bool IsAtRisk(const b2Joint& joint)
{
    // In radii of gyration. With two, chains of boxes with gaps have an account, too, which takes
    // 12 to 37 % more instructions (docs/notes/energy-accounts.md).
    constexpr float32 kLongLever = 4.0f;
    // A pull along a line turns a body straight within a sub-step, and is not foreseen. At 2.1
    // radii a rod gained 11 % of the energy of two circles.
    constexpr float32 kLongLeverOfLine = 2.0f;
    if (HaveUnequalMasses(Data(*joint.GetBodyA()), Data(*joint.GetBodyB())))
    {
        return true;
    }
    const float32 maximum = IsLine(joint) ? kLongLeverOfLine : kLongLever;
    return HasLeverOnB(joint, maximum) || HasLeverOnA(joint, maximum);
}

bool HasLeverOnA(const b2Joint& joint, float32 radii)
{
    // Forces on A act at the anchor of B, which may be far away.
    return HoldOf(joint) != JointHold::kTarget &&
           IsFarOut(*joint.GetBodyA(),
                    HasChangingLevers(joint) ? joint.GetAnchorB() : joint.GetAnchorA(), radii);
}

bool HasLeverOnB(const b2Joint& joint, float32 radii)
{
    return IsFarOut(*joint.GetBodyB(), joint.GetAnchorB(), radii);
}

bool HasChangingLevers(const b2Joint& joint)
{
    return HoldOf(joint) == JointHold::kSlide;
}

bool IsLine(const b2Joint& joint)
{
    return HoldOf(joint) == JointHold::kLine;
}

bool TurnsFar(const b2Joint& joint, float32 time)
{
    // [rad]: a force then turns by as much, and a quarter of it acts across the line. World 1300
    // gained 8.7 % of energy without this rule (docs/notes/energy-guard.md). No test fails with
    // 0.05 or 1.
    constexpr float32 kFar = 0.25f;
    if (!IsLine(joint))
    {
        return false;
    }
    const auto speedOf = [](const b2Body& body, const b2Vec2& anchor) {
        return body.GetLinearVelocityFromWorldPoint(anchor);
    };
    const b2Vec2 anchorA = joint.GetAnchorA();
    const b2Vec2 anchorB = joint.GetAnchorB();
    const b2Vec2 speedA = speedOf(*joint.GetBodyA(), anchorA);
    const b2Vec2 speedB = speedOf(*joint.GetBodyB(), anchorB);
    const auto turns = [time](const b2Vec2& speed, float32 length) {
        return time * speed.Length() > kFar * length;
    };
    if (joint.GetType() == e_pulleyJoint)
    {
        const auto& pulley = static_cast<const b2PulleyJoint&>(joint);
        return turns(speedA, pulley.GetCurrentLengthA()) ||
               turns(speedB, pulley.GetCurrentLengthB());
    }
    return turns(speedB - speedA, b2Distance(anchorA, anchorB));
}

bool HasSpring(const b2Joint& joint)
{
    return WithJoint(
        joint, []<class Joint>(const Joint& j) { return JointAccess::Kind<Joint>::HasSpring(j); });
}

SpringState SpringOf(const b2Joint& joint, const SolverBody* bodies)
{
    return WithJoint(joint, [&]<class Joint>(const Joint& j) {
        return JointAccess::Kind<Joint>::SpringOf(j,
                                                  JointPair(*j.GetBodyA(), *j.GetBodyB(), bodies));
    });
}

bool HasMotor(const b2Joint& joint)
{
    return WithJoint(
        joint, []<class Joint>(const Joint& j) { return JointAccess::Kind<Joint>::HasMotor(j); });
}

double MaxMotorWork(const b2Joint& joint, const SolverBody* bodies, float32 timeStep)
{
    const auto step = double(timeStep);
    return step * WithJoint(joint, [&]<class Joint>(const Joint& j) {
               const JointPair pair(*j.GetBodyA(), *j.GetBodyB(), bodies);
               return JointAccess::Kind<Joint>::MaxPower(j, pair, step);
           });
}

} // namespace box2d
