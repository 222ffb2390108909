// SPDX-License-Identifier: MIT
#include "../Joints/JointDefinitions.h"
#include "../State/Access.h"
#include "../State/World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
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

#include <iterator>

namespace box2d
{

namespace
{

/// Functions of a joint type: the table below has one line per type.
struct JointKind
{
    int32 size;
    b2Joint* (*construct)(void* memory, const b2JointDef* def);
};

template <class Joint, class Definition>
constexpr JointKind Kind()
{
    return {int32(sizeof(Joint)), &JointAccess::Construct<Joint, Definition>};
}

const JointKind* FindKind(b2JointType type)
{
    // In the order of b2JointType.
    static constexpr JointKind kKinds[] = {
        Kind<b2RevoluteJoint, b2RevoluteJointDef>(), Kind<b2PrismaticJoint, b2PrismaticJointDef>(),
        Kind<b2DistanceJoint, b2DistanceJointDef>(), Kind<b2PulleyJoint, b2PulleyJointDef>(),
        Kind<b2MouseJoint, b2MouseJointDef>(),       Kind<b2GearJoint, b2GearJointDef>(),
        Kind<b2WheelJoint, b2WheelJointDef>(),       Kind<b2WeldJoint, b2WeldJointDef>(),
        Kind<b2FrictionJoint, b2FrictionJointDef>(), Kind<b2RopeJoint, b2RopeJointDef>(),
        Kind<b2MotorJoint, b2MotorJointDef>(),
    };
    const int32 index = int32(type) - int32(e_revoluteJoint);
    return 0 <= index && index < int32(std::size(kKinds)) ? &kKinds[index] : nullptr;
}

void PushEdge(b2JointEdge& edge, b2Joint& joint, b2Body& body, b2Body& other)
{
    BodyData& data = Data(body);
    edge.joint = &joint;
    edge.other = &other;
    edge.next = data.jointList;
    if (data.jointList)
    {
        data.jointList->prev = &edge;
    }
    data.jointList = &edge;
}

void RemoveEdge(b2JointEdge& edge, b2Body& body)
{
    (edge.prev ? edge.prev->next : Data(body).jointList) = edge.next;
    if (edge.next)
    {
        edge.next->prev = edge.prev;
    }
}

/// Returns a gear that uses this joint, or null. It is attached to one of the joint's bodies.
b2Joint* FindGear(b2Joint& joint)
{
    for (b2Body* body : {joint.GetBodyB(), joint.GetBodyA()})
    {
        for (b2JointEdge* edge = body->GetJointList(); edge; edge = edge->next)
        {
            if (edge->joint->GetType() == e_gearJoint)
            {
                auto* gear = static_cast<b2GearJoint*>(edge->joint);
                if (gear->GetJoint1() == &joint || gear->GetJoint2() == &joint)
                {
                    return gear;
                }
            }
        }
    }
    return nullptr;
}

} // namespace

b2Joint* World::CreateJoint(const b2JointDef& def)
{
    if (!IsSound(def) ||
        !B2_REQUIRE(Data(*def.bodyA).world == this && Data(*def.bodyB).world == this,
                    "A joint needs two bodies of this world."))
    {
        return nullptr;
    }
    b2Joint& joint = ConstructJoint(def);
    JointAccess::Number(joint) = jointNumber++;
    LinkJoint(joint);
    UpdateActivity(joint);
    FlagJointContacts(joint);
    return &joint;
}

b2Joint& World::ConstructJoint(const b2JointDef& def)
{
    const JointKind* kind = FindKind(def.type);
    return *kind->construct(allocator.Allocate(kind->size), &def);
}

void World::LinkJoint(b2Joint& joint)
{
    JointAccess::Next(joint) = jointList;
    if (jointList)
    {
        JointAccess::Prev(*jointList) = &joint;
    }
    jointList = &joint;
    ++jointCount;
    gearCount += joint.GetType() == e_gearJoint;
    b2Body& bodyA = *joint.GetBodyA();
    b2Body& bodyB = *joint.GetBodyB();
    PushEdge(JointAccess::EdgeA(joint), joint, bodyA, bodyB);
    PushEdge(JointAccess::EdgeB(joint), joint, bodyB, bodyA);
}

void World::DestroyJointImplicitly(b2Joint& joint)
{
    if (destructionListener)
    {
        const Lock lock(*this);
        destructionListener->SayGoodbye(&joint);
    }
    DestroyJoint(joint);
}

void World::DestroyJoint(b2Joint& joint)
{
    while (b2Joint* gear = gearCount > 0 ? FindGear(joint) : nullptr)
    {
        DestroyJointImplicitly(*gear);
    }
    gearCount -= joint.GetType() == e_gearJoint;
    b2Body& a = *joint.GetBodyA();
    b2Body& b = *joint.GetBodyB();
    Wake(a);
    Wake(b);
    if (JointAccess::SolverIndex(joint) != -1)
    {
        graph.Remove(joint);
    }
    if (JointAccess::Linked(joint))
    {
        islands.Unlink(a, b);
    }
    RemoveEdge(JointAccess::EdgeA(joint), a);
    RemoveEdge(JointAccess::EdgeB(joint), b);
    (JointAccess::Prev(joint) ? JointAccess::Next(*JointAccess::Prev(joint)) : jointList) =
        joint.GetNext();
    if (joint.GetNext())
    {
        JointAccess::Prev(*joint.GetNext()) = JointAccess::Prev(joint);
    }
    --jointCount;
    // The bodies may collide again.
    if (!joint.GetCollideConnected())
    {
        for (b2Fixture* f = a.GetFixtureList(); f; f = f->GetNext())
        {
            Refilter(*f);
        }
    }
    const int32 size = FindKind(joint.GetType())->size;
    JointAccess::Destruct(joint);
    allocator.Free(&joint, size);
}

// Flags the contacts of a joint that disables collision between its bodies.
void World::FlagJointContacts(b2Joint& joint)
{
    if (joint.GetCollideConnected())
    {
        return;
    }
    for (b2ContactEdge* edge = joint.GetBodyB()->GetContactList(); edge; edge = edge->next)
    {
        if (edge->other == joint.GetBodyA())
        {
            Data(*edge->contact).flags |= kContactFilter;
            filtersChanged = true;
        }
    }
}

} // namespace box2d
