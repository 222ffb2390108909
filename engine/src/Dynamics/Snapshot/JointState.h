// SPDX-License-Identifier: MIT
#pragma once

#include "BodyState.h"

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

/// Joints of all types: settings, and impulses and directions of the last step.
namespace box2d
{

struct JointAccess::Snapshot
{
    /// Members common to all joints. The lists define their membership.
    template <class Archive>
    static void VisitBase(Archive& archive, b2Joint& j)
    {
        static_assert(kHasSize<b2Joint, 136>, "Say here what becomes of the new member.");
        archive(j.m_number, j.m_changedAt, j.m_linked, j.m_collideConnected);
        VisitUserData(archive, j.m_userData);
    }
    /// A gear keeps the bodies of its creation, even if its joints now move others.
    static void SetBodies(b2Joint& j, b2Body* a, b2Body* b)
    {
        j.m_bodyA = a;
        j.m_bodyB = b;
    }

    template <class Archive>
    static void Visit(Archive& archive, b2RevoluteJoint& j)
    {
        static_assert(kHasSize<b2RevoluteJoint, 200>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_referenceAngle, j.m_enableLimit,
                j.m_lowerAngle, j.m_upperAngle, j.m_enableMotor, j.m_motorSpeed,
                j.m_maxMotorTorque);
        archive(j.m_impulse, j.m_motorImpulse, j.m_limitImpulse);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2PrismaticJoint& j)
    {
        static_assert(kHasSize<b2PrismaticJoint, 216>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_localAxisA, j.m_referenceAngle,
                j.m_enableLimit, j.m_lowerTranslation, j.m_upperTranslation, j.m_enableMotor,
                j.m_maxMotorForce, j.m_motorSpeed);
        archive(j.m_impulse, j.m_motorImpulse, j.m_limitImpulse, j.m_axis);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2DistanceJoint& j)
    {
        static_assert(kHasSize<b2DistanceJoint, 208>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_length, j.m_frequencyHz, j.m_dampingRatio,
                j.m_minLength, j.m_maxLength, j.m_isLimited, j.m_restLength, j.m_springHz);
        archive(j.m_impulse, j.m_lowerImpulse, j.m_upperImpulse, j.m_axis);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2PulleyJoint& j)
    {
        static_assert(kHasSize<b2PulleyJoint, 200>, "Say here what becomes of the new member.");
        archive(j.m_groundAnchorA, j.m_groundAnchorB, j.m_localAnchorA, j.m_localAnchorB,
                j.m_lengthA, j.m_lengthB, j.m_ratio);
        archive(j.m_impulse, j.m_axisA, j.m_axisB);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2MouseJoint& j)
    {
        static_assert(kHasSize<b2MouseJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorB, j.m_target, j.m_maxForce, j.m_frequencyHz, j.m_dampingRatio);
        archive(j.m_impulse);
    }

    /// The two joints are given at construction.
    template <class Archive>
    static void Visit(Archive& archive, b2GearJoint& j)
    {
        static_assert(kHasSize<b2GearJoint, 312>, "Say here what becomes of the new member.");
        for (b2GearJoint::Side* side : {&j.m_side1, &j.m_side2})
        {
            auto& [joint, frame, body, slides, localAnchorFrame, localAnchorBody, localAxis,
                   referenceAngle, axis, armFrame, armBody] = *side;
            archive(localAnchorFrame, localAnchorBody, localAxis, referenceAngle);
            archive(axis, armFrame, armBody);
        }
        archive(j.m_constant, j.m_ratio, j.m_impulse);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2WheelJoint& j)
    {
        static_assert(kHasSize<b2WheelJoint, 200>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_localAxisA, j.m_enableMotor,
                j.m_maxMotorTorque, j.m_motorSpeed, j.m_frequencyHz, j.m_dampingRatio);
        archive(j.m_impulse, j.m_springImpulse, j.m_motorImpulse, j.m_axis);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2WeldJoint& j)
    {
        static_assert(kHasSize<b2WeldJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_referenceAngle, j.m_frequencyHz,
                j.m_dampingRatio);
        archive(j.m_impulse, j.m_angularImpulse);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2FrictionJoint& j)
    {
        static_assert(kHasSize<b2FrictionJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_maxForce, j.m_maxTorque);
        archive(j.m_impulse, j.m_angularImpulse);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2RopeJoint& j)
    {
        static_assert(kHasSize<b2RopeJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_maxLength);
        archive(j.m_impulse, j.m_axis, j.m_length);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2MotorJoint& j)
    {
        static_assert(kHasSize<b2MotorJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_linearOffset, j.m_angularOffset, j.m_maxForce, j.m_maxTorque,
                j.m_correctionFactor);
        archive(j.m_impulse, j.m_angularImpulse);
    }
};

/// The joints of a gear are older than the gear.
template <class Archive>
void VisitParts(Archive& archive, b2GearJointDef& def, b2Joint* joint)
{
    if (joint != nullptr)
    {
        def.joint1 = static_cast<b2GearJoint*>(joint)->GetJoint1();
        def.joint2 = static_cast<b2GearJoint*>(joint)->GetJoint2();
    }
    archive(def.joint1, def.joint2);
    for (const b2Joint* part : {def.joint1, def.joint2})
    {
        archive.Require(part != nullptr && (part->GetType() == e_revoluteJoint ||
                                            part->GetType() == e_prismaticJoint));
    }
}

template <class Archive>
void VisitParts(Archive&, b2JointDef&, b2Joint*)
{}

/// A joint of one type; null for reading. The result is null if there is none to read.
template <class Joint, class Definition, class Archive>
b2Joint* VisitKind(Archive& archive, World& world, b2Joint* joint)
{
    Definition def;
    if (joint != nullptr)
    {
        def.bodyA = joint->GetBodyA();
        def.bodyB = joint->GetBodyB();
    }
    archive(def.bodyA, def.bodyB);
    VisitParts(archive, def, joint);
    if constexpr (Archive::kReads)
    {
        archive.Require(def.bodyA != def.bodyB);
        if (!archive.IsSound())
        {
            return nullptr;
        }
        joint = &world.ConstructJoint(def);
        JointAccess::Snapshot::SetBodies(*joint, def.bodyA, def.bodyB);
        world.LinkJoint(*joint);
    }
    JointAccess::Snapshot::VisitBase(archive, *joint);
    JointAccess::Snapshot::Visit(archive, static_cast<Joint&>(*joint));
    return joint;
}

template <class Archive>
b2Joint* VisitJoint(Archive& archive, World& world, b2Joint* joint)
{
    b2JointType type = joint ? joint->GetType() : e_revoluteJoint;
    archive.Within(type, e_revoluteJoint, e_motorJoint);
    switch (type)
    {
    case e_revoluteJoint:
        return VisitKind<b2RevoluteJoint, b2RevoluteJointDef>(archive, world, joint);
    case e_prismaticJoint:
        return VisitKind<b2PrismaticJoint, b2PrismaticJointDef>(archive, world, joint);
    case e_distanceJoint:
        return VisitKind<b2DistanceJoint, b2DistanceJointDef>(archive, world, joint);
    case e_pulleyJoint:
        return VisitKind<b2PulleyJoint, b2PulleyJointDef>(archive, world, joint);
    case e_mouseJoint:
        return VisitKind<b2MouseJoint, b2MouseJointDef>(archive, world, joint);
    case e_gearJoint:
        return VisitKind<b2GearJoint, b2GearJointDef>(archive, world, joint);
    case e_wheelJoint:
        return VisitKind<b2WheelJoint, b2WheelJointDef>(archive, world, joint);
    case e_weldJoint:
        return VisitKind<b2WeldJoint, b2WeldJointDef>(archive, world, joint);
    case e_frictionJoint:
        return VisitKind<b2FrictionJoint, b2FrictionJointDef>(archive, world, joint);
    case e_ropeJoint:
        return VisitKind<b2RopeJoint, b2RopeJointDef>(archive, world, joint);
    default:
        return VisitKind<b2MotorJoint, b2MotorJointDef>(archive, world, joint);
    }
}

template <class Archive>
void VisitJoints(Archive& archive, World& world)
{
    constexpr std::size_t leastBytes = 48;
    const Array<b2Joint*> known = archive.lists.joints;
    auto count = int32(known.size());
    archive.Count(count, leastBytes);
    int32 number = -1;
    for (int32 i = 0; i < count && archive.IsSound(); ++i)
    {
        b2Joint* joint =
            VisitJoint(archive, world, Archive::kReads ? nullptr : known[std::size_t(i)]);
        if (joint == nullptr)
        {
            return;
        }
        archive.Require(JointAccess::Number(*joint) > number);
        number = JointAccess::Number(*joint);
        if constexpr (Archive::kReads)
        {
            archive.lists.joints.push_back(joint);
        }
    }
    archive.Require(number < world.jointNumber);
}

} // namespace box2d
