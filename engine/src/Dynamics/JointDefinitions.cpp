// SPDX-License-Identifier: MIT
#include "JointDefinitions.h"

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

namespace box2d
{

namespace
{

// One overload a kind of joint, found by the type of the definition; the helpers first.

bool AreAnchors(const b2Vec2& a, const b2Vec2& b)
{
    return B2_REQUIRE(a.IsValid() && b.IsValid(), "A joint's anchors must be finite.");
}

bool IsAxis(const b2Vec2& axis)
{
    return B2_REQUIRE(axis.IsValid() && axis.LengthSquared() > 0.0f,
                      "A joint's axis must be finite and not zero.");
}

bool IsAngle(float32 angle)
{
    return B2_REQUIRE(b2IsValid(angle), "A joint's angles must be finite.");
}

bool IsLength(float32 length)
{
    return B2_REQUIRE(b2IsValid(length) && length >= 0.0f,
                      "A joint's length must be finite and not negative.");
}

bool IsSpring(float32 frequencyHz, float32 dampingRatio)
{
    return B2_REQUIRE(b2IsValid(frequencyHz) && frequencyHz >= 0.0f && b2IsValid(dampingRatio) &&
                          dampingRatio >= 0.0f,
                      "A joint's frequency and damping ratio must be finite and not negative.");
}

bool AreLimits(bool enabled, float32 lower, float32 upper)
{
    return B2_REQUIRE(b2IsValid(lower) && b2IsValid(upper) && (!enabled || lower <= upper),
                      "A joint's limits must be finite, the lower limit not above the upper one.");
}

// The largest force may be infinite: a motor that nothing stops.
bool IsMotor(float32 speed, float32 largest)
{
    return B2_REQUIRE(b2IsValid(speed) && largest >= 0.0f,
                      "A joint's motor needs a finite speed and a largest force or torque that is "
                      "not negative.");
}

bool AreForces(float32 force, float32 torque)
{
    return B2_REQUIRE(force >= 0.0f && torque >= 0.0f,
                      "A joint's largest force and torque must not be negative.");
}

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
           IsSpring(d.frequencyHz, d.dampingRatio);
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
    return B2_REQUIRE(d.target.IsValid(), "A mouse joint's target must be finite.") &&
           AreForces(d.maxForce, 0.0f) && IsSpring(d.frequencyHz, d.dampingRatio);
}

bool HasCoordinate(const b2Joint* joint)
{
    return joint && (joint->GetType() == e_revoluteJoint || joint->GetType() == e_prismaticJoint);
}

bool IsSoundKind(const b2GearJointDef& d)
{
    return B2_REQUIRE(HasCoordinate(d.joint1) && HasCoordinate(d.joint2),
                      "A gear joint needs two joints, each revolute or prismatic.") &&
           B2_REQUIRE(d.joint1->GetBodyB() != d.joint2->GetBodyB(),
                      "A gear joint's two joints must move two different bodies (their bodies "
                      "B).") &&
           B2_REQUIRE(b2IsValid(d.ratio), "A gear joint's ratio must be finite.");
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
    return B2_REQUIRE(d.linearOffset.IsValid() && b2IsValid(d.angularOffset),
                      "A motor joint's offsets must be finite.") &&
           AreForces(d.maxForce, d.maxTorque) &&
           B2_REQUIRE(d.correctionFactor >= 0.0f && d.correctionFactor <= 1.0f,
                      "A motor joint's correction factor must be between 0 and 1.");
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
