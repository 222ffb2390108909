// SPDX-License-Identifier: MIT
#include "../State/Access.h"
#include "../State/World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/Joints/b2PrismaticJoint.h>
#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>
#include <Box2D/Dynamics/Joints/b2WheelJoint.h>
#include <Box2D/Dynamics/b2Body.h>

/// Sleeping and waking. A step reads only the lists of awake bodies, awake contacts and coloured
/// constraints; this file maintains them.
namespace box2d
{

namespace
{

bool IsListed(const BodyData& body)
{
    return body.awakeIndex != -1;
}

bool IsPushed(const BodyData& body)
{
    return IsListed(body) && body.IsDynamic();
}

bool IsMovingPlatform(const BodyData& body)
{
    return body.mobility == Mobility::Kinematic &&
           (body.linearVelocity != b2Vec2(0.0f, 0.0f) || body.angularVelocity != 0.0f);
}

/// True if it moves at its motor's target speed. A blocked motor may rest.
template <class Joint>
bool IsDriven(const b2Joint& joint)
{
    const auto& driven = static_cast<const Joint&>(joint);
    const float32 told = driven.IsMotorEnabled() ? driven.GetMotorSpeed() : 0.0f;
    return told != 0.0f && driven.GetJointSpeed() / told > 0.5f;
}

bool IsDriven(const b2Joint& joint)
{
    switch (joint.GetType())
    {
    case e_revoluteJoint:
        return IsDriven<b2RevoluteJoint>(joint);
    case e_prismaticJoint:
        return IsDriven<b2PrismaticJoint>(joint);
    case e_wheelJoint:
        return IsDriven<b2WheelJoint>(joint);
    default:
        return false;
    }
}

} // namespace

void World::UpdateActivity(b2Body& body)
{
    BodyData& data = Data(body);
    const bool listed = data.IsAwake() && data.IsActive() && data.mobility != Mobility::Static;
    if (listed && !IsListed(data))
    {
        data.awakeIndex = int32(awakeBodies.size());
        awakeBodies.push_back(&body);
    }
    else if (!listed && IsListed(data))
    {
        b2Body* last = awakeBodies.back();
        awakeBodies[std::size_t(data.awakeIndex)] = last;
        Data(*last).awakeIndex = data.awakeIndex;
        awakeBodies.pop_back();
        data.awakeIndex = -1;
    }
    for (b2ContactEdge* edge = data.contactList; edge; edge = edge->next)
    {
        UpdateActivity(*edge->contact);
    }
    for (b2JointEdge* edge = data.jointList; edge; edge = edge->next)
    {
        UpdateActivity(*edge->joint);
    }
}

void World::UpdateActivity(b2Contact& contact)
{
    ContactData& c = Data(contact);
    const BodyData& a = Data(*c.bodyA);
    const BodyData& b = Data(*c.bodyB);

    const bool awake = IsListed(a) || IsListed(b);
    if (awake && c.awakeIndex == -1)
    {
        c.awakeIndex = int32(awakeContacts.size());
        awakeContacts.push_back(&contact);
    }
    else if (!awake && c.awakeIndex != -1)
    {
        b2Contact* last = awakeContacts.back();
        awakeContacts[std::size_t(c.awakeIndex)] = last;
        Data(*last).awakeIndex = c.awakeIndex;
        awakeContacts.pop_back();
        c.awakeIndex = -1;
        // A listener put a body to sleep before the second phase of the contact's update, which is
        // then cancelled.
        ForgetUpdate(c);
    }

    const bool solved = c.IsTouching() && !c.IsSensor() && (IsPushed(a) || IsPushed(b));
    if (solved && c.color == -1)
    {
        graph.Add(contact);
    }
    else if (!solved && c.color != -1)
    {
        graph.Remove(contact);
    }

    const bool linked = c.IsTouching() && !c.IsSensor() && a.island != -1 && b.island != -1;
    if (linked && (c.flags & kContactLinked) == 0)
    {
        c.flags |= kContactLinked;
        islands.Link(*c.bodyA, *c.bodyB);
    }
    else if (!linked && (c.flags & kContactLinked) != 0)
    {
        c.flags &= ~std::uint32_t(kContactLinked);
        islands.Unlink(*c.bodyA, *c.bodyB);
    }
}

void World::UpdateActivity(b2Joint& joint)
{
    const BodyData& a = Data(*joint.GetBodyA());
    const BodyData& b = Data(*joint.GetBodyB());
    const bool active = a.IsActive() && b.IsActive();

    const bool solved = active && (IsPushed(a) || IsPushed(b));
    if (solved && JointAccess::SolverIndex(joint) == -1)
    {
        graph.Add(joint);
    }
    else if (!solved && JointAccess::SolverIndex(joint) != -1)
    {
        graph.Remove(joint);
    }

    const bool linked = active && a.island != -1 && b.island != -1;
    if (linked != JointAccess::Linked(joint))
    {
        JointAccess::Linked(joint) = linked;
        linked ? islands.Link(*joint.GetBodyA(), *joint.GetBodyB())
               : islands.Unlink(*joint.GetBodyA(), *joint.GetBodyB());
    }
}

void World::Wake(b2Body& body)
{
    BodyData& data = Data(body);
    if (data.IsAwake())
    {
        return;
    }
    const auto wakeOne = [this](b2Body& one) {
        if (!Data(one).IsAwake())
        {
            Data(one).flags |= kBodyAwake;
            Data(one).sleepTime = 0.0f;
            UpdateActivity(one);
        }
    };
    if (data.island == -1)
    {
        wakeOne(body);
        return;
    }
    for (b2Body* member = islands.At(data.island).first; member;)
    {
        b2Body* next = Data(*member).islandNext;
        wakeOne(*member);
        member = next;
    }
}

void World::PutToSleep(b2Body& body)
{
    BodyData& data = Data(body);
    if (!data.IsAwake())
    {
        return;
    }
    data.flags &= ~std::uint32_t(kBodyAwake);
    data.sleepTime = 0.0f;
    data.previous = data.pose;
    data.sweepStart = 0.0f;
    data.linearVelocity.SetZero();
    data.angularVelocity = 0.0f;
    data.force.SetZero();
    data.torque = 0.0f;
    UpdateActivity(body);
}

void World::PutToSleep(int32 island)
{
    for (b2Body* member = islands.At(island).first; member; member = Data(*member).islandNext)
    {
        PutToSleep(*member);
    }
}

void World::WakeAttached(b2Body& body)
{
    const BodyData& data = Data(body);
    for (b2ContactEdge* edge = data.contactList; edge; edge = edge->next)
    {
        Wake(*edge->other);
        Wake(body);
    }
    for (b2JointEdge* edge = data.jointList; edge; edge = edge->next)
    {
        Wake(*edge->other);
        Wake(body);
    }
}

bool World::WakesNeighbours(const BodyData& a, const BodyData& b)
{
    return (a.IsDynamic() && !a.IsAwake()) || (b.IsDynamic() && !b.IsAwake()) ||
           IsMovingPlatform(a) || IsMovingPlatform(b);
}

void World::WakeNeighbours(b2Body& bodyA, b2Body& bodyB)
{
    BodyData& a = Data(bodyA);
    BodyData& b = Data(bodyB);
    if (a.IsDynamic() && !a.IsAwake() && (IsPushed(b) || IsMovingPlatform(b)))
    {
        Wake(bodyA);
    }
    if (b.IsDynamic() && !b.IsAwake() && (IsPushed(a) || IsMovingPlatform(a)))
    {
        Wake(bodyB);
    }
    // A moving platform keeps the bodies on it awake.
    if (IsMovingPlatform(a))
    {
        b.sleepTime = 0.0f;
    }
    if (IsMovingPlatform(b))
    {
        a.sleepTime = 0.0f;
    }
}

void World::KeepDrivenAwake(b2Joint& joint)
{
    BodyData& a = Data(*joint.GetBodyA());
    BodyData& b = Data(*joint.GetBodyB());
    // Tested rarely, because fast bodies have no sleep time.
    if ((a.sleepTime > 0.0f || b.sleepTime > 0.0f) && IsDriven(joint))
    {
        a.sleepTime = 0.0f;
        b.sleepTime = 0.0f;
    }
}

} // namespace box2d
