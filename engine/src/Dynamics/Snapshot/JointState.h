// SPDX-License-Identifier: MIT
#pragma once

#include "../Joints/JointKinds.h"
#include "../World/Joints.h"
#include "BodyState.h"

/// Joints of all kinds: their settings, and the impulses and directions of the last step.
namespace box2d
{

struct JointAccess::Snapshot
{
    /// Visits the members that all joints have. The lists that contain the joint are saved
    /// separately.
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
        archive.Require(CanBeGeared(part));
    }
}

template <class Archive>
void VisitParts(Archive&, b2JointDef&, b2Joint*)
{}

/// A joint of one class. `joint` is null when it is to be read. Returns null when it cannot be.
template <class Joint, class Archive>
b2Joint* VisitKind(Archive& archive, World& world, b2Joint* joint)
{
    using Kind = JointAccess::Kind<Joint>;
    typename Kind::Definition def;
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
        joint = &ConstructJoint(def, world.allocator);
        JointAccess::Snapshot::SetBodies(*joint, def.bodyA, def.bodyB);
        LinkJoint(world, *joint);
    }
    JointAccess::Snapshot::VisitBase(archive, *joint);
    Kind::Visit(archive, static_cast<Joint&>(*joint));
    return joint;
}

template <class Archive>
b2Joint* VisitJoint(Archive& archive, World& world, b2Joint* joint)
{
    static_assert(!IsJointType(b2JointType(e_motorJoint + 1)), "Put the last kind below.");
    b2JointType type = joint ? joint->GetType() : e_revoluteJoint;
    archive.Within(type, e_revoluteJoint, e_motorJoint);
    return WithType(type, [&]<class Joint>(JointTag<Joint>) {
        return VisitKind<Joint>(archive, world, joint);
    });
}

template <class Archive>
void VisitJoints(Archive& archive, World& world)
{
    constexpr std::size_t minBytes = 48;
    const Array<b2Joint*> known = archive.lists.joints;
    auto count = int32(known.size());
    archive.Count(count, minBytes);
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
