// SPDX-License-Identifier: MIT
#include "../Joints/JointKinds.h"
#include "../State/Access.h"
#include "../State/World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

namespace box2d
{

namespace
{

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

/// A gear that is made of this joint, null when there is none. It hangs on one of the joint's
/// bodies.
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
    b2Joint& joint = ConstructJoint(def, allocator);
    JointAccess::Number(joint) = jointNumber++;
    LinkJoint(joint);
    UpdateActivity(joint);
    FlagJointContacts(joint);
    return &joint;
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
    // The bodies may collide from now on.
    if (!joint.GetCollideConnected())
    {
        for (b2Fixture* f = a.GetFixtureList(); f; f = f->GetNext())
        {
            Refilter(*f);
        }
    }
    DestructJoint(joint, allocator);
}

// A joint that keeps its bodies from colliding ends the contacts they have.
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
