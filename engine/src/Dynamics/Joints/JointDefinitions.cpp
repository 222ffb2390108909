// SPDX-License-Identifier: MIT
#include "JointDefinitions.h"

#include "../State/Access.h"

#include "JointChecks.h"

#include <Box2D/Dynamics/Joints/b2DistanceJoint.h>
#include <Box2D/Dynamics/Joints/b2FrictionJoint.h>
#include <Box2D/Dynamics/Joints/b2GearJoint.h>
#include <Box2D/Dynamics/Joints/b2MotorJoint.h>
#include <Box2D/Dynamics/Joints/b2MouseJoint.h>
#include <Box2D/Dynamics/Joints/b2PrismaticJoint.h>
#include <Box2D/Dynamics/Joints/b2PulleyJoint.h>
#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>
#include <Box2D/Dynamics/Joints/b2RopeJoint.h>
#include <Box2D/Dynamics/Joints/b2WeldJoint.h>
#include <Box2D/Dynamics/Joints/b2WheelJoint.h>
#include <Box2D/Dynamics/b2Body.h>

namespace box2d
{

namespace
{

/// True if the connected component of the gear's bodies includes those of this joint, with the gear
/// between `body` and a body of the other joint.
bool Reaches(b2Joint& joint, const b2Body& body, b2Joint& otherJoint)
{
    b2Body& other = *(&body == joint.GetBodyA() ? joint.GetBodyB() : joint.GetBodyA());
    return Data(body).IsDynamic() || !Data(other).IsDynamic() || &other == otherJoint.GetBodyA() ||
           &other == otherJoint.GetBodyB();
}

/// The definition's body first, otherwise the joint's second one.
void SortBodies(b2Joint& joint, b2Body* wish, b2Body* (&bodies)[2])
{
    bodies[0] = wish == joint.GetBodyA() ? wish : joint.GetBodyB();
    bodies[1] = bodies[0] == joint.GetBodyA() ? joint.GetBodyB() : joint.GetBodyA();
}

} // namespace

GearBodies BodiesOf(const b2GearJointDef& def)
{
    b2Body* first[2];
    b2Body* second[2];
    SortBodies(*def.joint1, def.bodyA, first);
    SortBodies(*def.joint2, def.bodyB, second);
    GearBodies unmoved;
    for (b2Body* a : first)
    {
        for (b2Body* b : second)
        {
            if (a == b)
            {
                continue;
            }
            if ((Data(*a).IsDynamic() || Data(*b).IsDynamic()) &&
                Reaches(*def.joint1, *a, *def.joint2) && Reaches(*def.joint2, *b, *def.joint1))
            {
                return {a, b};
            }
            unmoved = unmoved.a == nullptr ? GearBodies{a, b} : unmoved;
        }
    }
    return unmoved;
}

namespace
{

// One overload per joint type, selected by the type of the definition.

bool IsSoundKind(const b2RevoluteJointDef& d)
{
    return AreAnchors(d.localAnchorA, d.localAnchorB) && IsAngle(d.referenceAngle) &&
           AreLimits(d.enableLimit, d.lowerAngle, d.upperAngle) &&
           IsMotor(d.motorSpeed, d.maxMotorTorque);
}

bool IsSoundKind(const b2PrismaticJointDef& d)
{
    return AreAnchors(d.localAnchorA, d.localAnchorB) && IsAxis(d.localAxisA) &&
           IsAngle(d.referenceAngle) &&
           AreLimits(d.enableLimit, d.lowerTranslation, d.upperTranslation) &&
           IsMotor(d.motorSpeed, d.maxMotorForce);
}

bool IsSoundKind(const b2DistanceJointDef& d)
{
    return AreAnchors(d.localAnchorA, d.localAnchorB) && IsLength(d.length) &&
           IsSpring(d.frequencyHz, d.dampingRatio) && IsLength(d.minLength) &&
           IsMaxLength(d.maxLength) &&
           B2_REQUIRE(d.minLength <= d.maxLength,
                      "A distance joint's minimum length must not exceed its maximum length.");
}

bool IsSoundKind(const b2PulleyJointDef& d)
{
    return AreAnchors(d.groundAnchorA, d.groundAnchorB) &&
           AreAnchors(d.localAnchorA, d.localAnchorB) && IsLength(d.lengthA) &&
           IsLength(d.lengthB) &&
           B2_REQUIRE(b2IsValid(d.ratio) && d.ratio > 0.0f,
                      "A pulley joint's ratio must be finite and positive.");
}

bool IsSoundKind(const b2MouseJointDef& d)
{
    return IsTarget(d.target) && AreForces(d.maxForce, 0.0f) &&
           IsSpring(d.frequencyHz, d.dampingRatio);
}

bool HasCoordinate(const b2Joint* joint)
{
    return joint && (joint->GetType() == e_revoluteJoint || joint->GetType() == e_prismaticJoint);
}

bool IsOfWorld(const b2Joint& joint, const b2World* world)
{
    return joint.GetBodyA()->GetWorld() == world;
}

bool IsSoundKind(const b2GearJointDef& d)
{
    return B2_REQUIRE(HasCoordinate(d.joint1) && HasCoordinate(d.joint2),
                      "A gear joint needs two joints, each revolute or prismatic.") &&
           B2_REQUIRE(d.joint1 != d.joint2 && BodiesOf(d).a != nullptr,
                      "A gear joint's two joints must move two different bodies.") &&
           B2_REQUIRE(IsOfWorld(*d.joint1, d.bodyA->GetWorld()) &&
                          IsOfWorld(*d.joint2, d.bodyA->GetWorld()),
                      "A gear joint's two joints must be of the world of its bodies.") &&
           IsGearRatio(d.ratio);
}

bool IsSoundKind(const b2WheelJointDef& d)
{
    return AreAnchors(d.localAnchorA, d.localAnchorB) && IsAxis(d.localAxisA) &&
           IsMotor(d.motorSpeed, d.maxMotorTorque) && IsSpring(d.frequencyHz, d.dampingRatio);
}

bool IsSoundKind(const b2WeldJointDef& d)
{
    return AreAnchors(d.localAnchorA, d.localAnchorB) && IsAngle(d.referenceAngle) &&
           IsSpring(d.frequencyHz, d.dampingRatio);
}

bool IsSoundKind(const b2FrictionJointDef& d)
{
    return AreAnchors(d.localAnchorA, d.localAnchorB) && AreForces(d.maxForce, d.maxTorque);
}

bool IsSoundKind(const b2RopeJointDef& d)
{
    return AreAnchors(d.localAnchorA, d.localAnchorB) && IsLength(d.maxLength);
}

bool IsSoundKind(const b2MotorJointDef& d)
{
    return IsTarget(d.linearOffset) && IsAngle(d.angularOffset) &&
           AreForces(d.maxForce, d.maxTorque) && IsShare(d.correctionFactor);
}

template <class Definition>
bool Ask(const b2JointDef& def)
{
    return IsSoundKind(static_cast<const Definition&>(def));
}

bool HasSoundNumbers(const b2JointDef& def)
{
    switch (def.type)
    {
    case e_revoluteJoint:
        return Ask<b2RevoluteJointDef>(def);
    case e_prismaticJoint:
        return Ask<b2PrismaticJointDef>(def);
    case e_distanceJoint:
        return Ask<b2DistanceJointDef>(def);
    case e_pulleyJoint:
        return Ask<b2PulleyJointDef>(def);
    case e_mouseJoint:
        return Ask<b2MouseJointDef>(def);
    case e_gearJoint:
        return Ask<b2GearJointDef>(def);
    case e_wheelJoint:
        return Ask<b2WheelJointDef>(def);
    case e_weldJoint:
        return Ask<b2WeldJointDef>(def);
    case e_frictionJoint:
        return Ask<b2FrictionJointDef>(def);
    case e_ropeJoint:
        return Ask<b2RopeJointDef>(def);
    case e_motorJoint:
        return Ask<b2MotorJointDef>(def);
    default:
        return B2_REQUIRE(false,
                          "b2World::CreateJoint: the definition's type is not that of a joint.");
    }
}

} // namespace

bool IsSound(const b2JointDef& def)
{
    return B2_REQUIRE(def.bodyA && def.bodyB, "A joint needs two bodies: set bodyA and bodyB.") &&
           B2_REQUIRE(def.bodyA != def.bodyB, "A joint needs two different bodies.") &&
           HasSoundNumbers(def);
}

} // namespace box2d
