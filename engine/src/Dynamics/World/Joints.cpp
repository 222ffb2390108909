// SPDX-License-Identifier: MIT
#include "Joints.h"

#include "../Islands/Sleep.h"
#include "../Joints/JointKinds.h"
#include "../State/Access.h"
#include "../State/BodyEdges.h"
#include "../State/World.h"
#include "Fixtures.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

namespace box2d
{

namespace
{

/// Returns a gear that uses this joint; null if there is none. It is in the list of one of the
/// joint's bodies.
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

/// A joint that keeps its bodies from colliding ends the contacts they have.
void FlagJointContacts(World& world, b2Joint& joint)
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
            world.filtersChanged = true;
        }
    }
}

} // namespace

b2Joint* CreateJoint(World& world, const b2JointDef& def)
{
    if (!IsSound(def) ||
        !B2_REQUIRE(Data(*def.bodyA).world == &world && Data(*def.bodyB).world == &world,
                    "A joint needs two bodies of this world."))
    {
        return nullptr;
    }
    b2Joint& joint = ConstructJoint(def, world.allocator);
    JointAccess::Number(joint) = world.jointNumber++;
    LinkJoint(world, joint);
    UpdateActivity(world, joint);
    FlagJointContacts(world, joint);
    return &joint;
}

void LinkJoint(World& world, b2Joint& joint)
{
    JointAccess::Next(joint) = world.jointList;
    if (world.jointList)
    {
        JointAccess::Prev(*world.jointList) = &joint;
    }
    world.jointList = &joint;
    ++world.jointCount;
    world.gearCount += joint.GetType() == e_gearJoint;
    b2JointEdge& edgeA = JointAccess::EdgeA(joint);
    b2JointEdge& edgeB = JointAccess::EdgeB(joint);
    edgeA.joint = edgeB.joint = &joint;
    edgeA.other = joint.GetBodyB();
    edgeB.other = joint.GetBodyA();
    PushEdge(Data(*joint.GetBodyA()).jointList, edgeA);
    PushEdge(Data(*joint.GetBodyB()).jointList, edgeB);
}

void DestroyJointImplicitly(World& world, b2Joint& joint)
{
    if (world.destructionListener)
    {
        const Lock lock(world);
        world.destructionListener->SayGoodbye(&joint);
    }
    DestroyJoint(world, joint);
}

void DestroyJoint(World& world, b2Joint& joint)
{
    while (b2Joint* gear = world.gearCount > 0 ? FindGear(joint) : nullptr)
    {
        DestroyJointImplicitly(world, *gear);
    }
    world.gearCount -= joint.GetType() == e_gearJoint;
    b2Body& a = *joint.GetBodyA();
    b2Body& b = *joint.GetBodyB();
    Wake(world, a);
    Wake(world, b);
    if (JointAccess::SolverIndex(joint) != -1)
    {
        world.graph.Remove(joint);
    }
    if (JointAccess::Linked(joint))
    {
        world.islands.Unlink(a, b);
    }
    RemoveEdge(Data(a).jointList, JointAccess::EdgeA(joint));
    RemoveEdge(Data(b).jointList, JointAccess::EdgeB(joint));
    (JointAccess::Prev(joint) ? JointAccess::Next(*JointAccess::Prev(joint)) : world.jointList) =
        joint.GetNext();
    if (joint.GetNext())
    {
        JointAccess::Prev(*joint.GetNext()) = JointAccess::Prev(joint);
    }
    --world.jointCount;
    // The bodies may collide from now on.
    if (!joint.GetCollideConnected())
    {
        for (b2Fixture* f = a.GetFixtureList(); f; f = f->GetNext())
        {
            Refilter(world, *f);
        }
    }
    DestructJoint(joint, world.allocator);
}

} // namespace box2d
