// SPDX-License-Identifier: MIT
#include "Access.h"
#include "World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/Joints/b2DistanceJoint.h>
#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>
#include <Box2D/Dynamics/b2Body.h>

namespace box2d
{

namespace
{

/// How a kind of joint is made: the table below has one line a kind.
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
    static constexpr JointKind kRevolute = Kind<b2RevoluteJoint, b2RevoluteJointDef>();
    static constexpr JointKind kDistance = Kind<b2DistanceJoint, b2DistanceJointDef>();
    switch (type)
    {
    case e_revoluteJoint:
        return &kRevolute;
    case e_distanceJoint:
        return &kDistance;
    default:
        return nullptr;
    }
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

} // namespace

b2Joint* World::CreateJoint(const b2JointDef& def)
{
    const JointKind* kind = FindKind(def.type);
    if (!B2_REQUIRE(kind != nullptr,
                    "b2World::CreateJoint: the definition's type is not that of a joint.") ||
        !B2_REQUIRE(def.bodyA && def.bodyB, "A joint needs two bodies: set bodyA and bodyB.") ||
        !B2_REQUIRE(def.bodyA != def.bodyB, "A joint needs two different bodies."))
    {
        return nullptr;
    }
    b2Joint* joint = kind->construct(allocator.Allocate(kind->size), &def);
    JointAccess::Number(*joint) = jointNumber++;
    JointAccess::Next(*joint) = jointList;
    if (jointList)
    {
        JointAccess::Prev(*jointList) = joint;
    }
    jointList = joint;
    ++jointCount;
    PushEdge(JointAccess::EdgeA(*joint), *joint, *def.bodyA, *def.bodyB);
    PushEdge(JointAccess::EdgeB(*joint), *joint, *def.bodyB, *def.bodyA);
    UpdateActivity(*joint);
    FlagJointContacts(*joint);
    return joint;
}

void World::DestroyJoint(b2Joint& joint)
{
    b2Body& a = *joint.GetBodyA();
    b2Body& b = *joint.GetBodyB();
    Wake(a);
    Wake(b);
    if (JointAccess::Color(joint) != -1)
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
    const int32 size = FindKind(joint.GetType())->size;
    JointAccess::Destruct(joint);
    allocator.Free(&joint, size);
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
