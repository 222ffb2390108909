// SPDX-License-Identifier: MIT
#include "Sleep.h"

#include "../State/Access.h"
#include "../State/World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

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

/// Initial capacity of the lists of awake contacts, to avoid repeated growth in small worlds. It
/// affects allocations only: from 1 to 64 each list would grow six times.
constexpr std::size_t kFirstRoom = 64;

void NoteAwake(World& world, const ContactData& c)
{
    world.awakeObstacles.push_back((c.flags & kContactObstacle) != 0);
    const float32 gap = c.IsEnabled() ? c.gap : 0.0f; // otherwise the next update has to enable it
    world.awakeLooks.push_back(
        {&Data(*c.bodyA), &Data(*c.bodyB), c.proxyA, c.proxyB, c.relative, gap});
}

} // namespace

bool IsMovingPlatform(const BodyData& body)
{
    return body.mobility == Mobility::Kinematic &&
           (body.linearVelocity != b2Vec2(0.0f, 0.0f) || body.angularVelocity != 0.0f);
}

void ForgetUpdate(World& world, ContactData& c)
{
    if ((c.flags & kContactComputed) != 0)
    {
        c.flags &= ~std::uint32_t(kContactComputed | kContactApart);
        ForgetManifold(world, c);
        if (c.oldIndex != -1)
        {
            c.manifold = world.oldManifolds[std::size_t(c.oldIndex)]; // a listener is the cause
        }
    }
}

void UpdateActivity(World& world, b2Body& body)
{
    BodyData& data = Data(body);
    const bool listed = data.IsAwake() && data.IsActive() && data.mobility != Mobility::Static;
    if (listed && !IsListed(data))
    {
        ++world.awakeVersion;
        data.awakeIndex = int32(world.awakeBodies.size());
        world.awakeBodies.push_back(&body);
    }
    else if (!listed && IsListed(data))
    {
        ++world.awakeVersion;
        b2Body* last = world.awakeBodies.back();
        world.awakeBodies[std::size_t(data.awakeIndex)] = last;
        Data(*last).awakeIndex = data.awakeIndex;
        world.awakeBodies.pop_back();
        data.awakeIndex = -1;
    }
    for (b2ContactEdge* edge = data.contactList; edge; edge = edge->next)
    {
        UpdateActivity(world, *edge->contact);
    }
    for (b2JointEdge* edge = data.jointList; edge; edge = edge->next)
    {
        UpdateActivity(world, *edge->joint);
    }
}

void RemoveFromAwake(World& world, ContactData& c)
{
    const auto index = std::size_t(c.awakeIndex);
    b2Contact* last = world.awakeContacts.back();
    world.awakeContacts[index] = last;
    world.awakeObstacles[index] = world.awakeObstacles.back();
    world.awakeLooks[index] = world.awakeLooks.back();
    Data(*last).awakeIndex = c.awakeIndex;
    world.awakeContacts.pop_back();
    world.awakeObstacles.pop_back();
    world.awakeLooks.pop_back();
    c.awakeIndex = -1;
}

void NoteAwakeContacts(World& world)
{
    world.awakeObstacles.clear();
    world.awakeLooks.clear();
    for (b2Contact* contact : world.awakeContacts)
    {
        NoteAwake(world, Data(*contact));
    }
}

void LookAgain(World& world, const ContactData& c)
{
    if (c.awakeIndex != -1)
    {
        PairLook& look = world.awakeLooks[std::size_t(c.awakeIndex)];
        look.gap = 0.0f;
        look.kept = look.unchanged = false;
    }
}

void ForgetManifold(World& world, ContactData& c)
{
    c.flags &= ~std::uint32_t(kContactKept);
    c.gap = 0.0f;
    LookAgain(world, c);
}

void UpdateActivity(World& world, b2Contact& contact)
{
    ContactData& c = Data(contact);
    const BodyData& a = Data(*c.bodyA);
    const BodyData& b = Data(*c.bodyB);

    const bool awake = IsListed(a) || IsListed(b);
    if (awake && c.awakeIndex == -1)
    {
        c.awakeIndex = int32(world.awakeContacts.size());
        c.gap = 0.0f;
        MakeRoom(world.awakeContacts, kFirstRoom);
        MakeRoom(world.awakeObstacles, kFirstRoom);
        MakeRoom(world.awakeLooks, kFirstRoom);
        world.awakeContacts.push_back(&contact);
        NoteAwake(world, c);
    }
    else if (!awake && c.awakeIndex != -1)
    {
        RemoveFromAwake(world, c);
        // A listener let a body sleep before the contact's turn in the present update has come:
        // then it has none.
        ForgetUpdate(world, c);
    }

    const bool solved = c.IsTouching() && !c.IsSensor() && (IsPushed(a) || IsPushed(b));
    if (solved && c.color == -1)
    {
        world.graph.Add(contact);
    }
    else if (!solved && c.color != -1)
    {
        world.graph.Remove(contact);
    }

    const bool linked = c.IsTouching() && !c.IsSensor() && a.island != -1 && b.island != -1;
    if (linked && (c.flags & kContactLinked) == 0)
    {
        c.flags |= kContactLinked;
        world.islands.Link(*c.bodyA, *c.bodyB);
    }
    else if (!linked && (c.flags & kContactLinked) != 0)
    {
        c.flags &= ~std::uint32_t(kContactLinked);
        world.islands.Unlink(*c.bodyA, *c.bodyB);
    }
}

void UpdateActivity(World& world, b2Joint& joint)
{
    const BodyData& a = Data(*joint.GetBodyA());
    const BodyData& b = Data(*joint.GetBodyB());
    const bool active = a.IsActive() && b.IsActive();

    const bool solved = active && (IsPushed(a) || IsPushed(b));
    if (solved && JointAccess::SolverIndex(joint) == -1)
    {
        world.graph.Add(joint);
    }
    else if (!solved && JointAccess::SolverIndex(joint) != -1)
    {
        world.graph.Remove(joint);
    }

    const bool linked = active && a.island != -1 && b.island != -1;
    if (linked != JointAccess::Linked(joint))
    {
        JointAccess::Linked(joint) = linked;
        linked ? world.islands.Link(*joint.GetBodyA(), *joint.GetBodyB())
               : world.islands.Unlink(*joint.GetBodyA(), *joint.GetBodyB());
    }
}

void Wake(World& world, b2Body& body)
{
    BodyData& data = Data(body);
    if (data.IsAwake())
    {
        return;
    }
    const auto wakeOne = [&world](b2Body& one) {
        if (!Data(one).IsAwake())
        {
            Data(one).flags |= kBodyAwake;
            Data(one).sleepTime = 0.0f;
            UpdateActivity(world, one);
        }
    };
    if (data.island == -1)
    {
        wakeOne(body);
        return;
    }
    for (b2Body* member = world.islands.At(data.island).first; member;)
    {
        b2Body* next = Data(*member).islandNext;
        wakeOne(*member);
        member = next;
    }
}

void PutToSleep(World& world, b2Body& body)
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
    UpdateActivity(world, body);
}

void PutToSleep(World& world, int32 island)
{
    for (b2Body* member = world.islands.At(island).first; member; member = Data(*member).islandNext)
    {
        PutToSleep(world, *member);
    }
}

void WakeAttached(World& world, b2Body& body)
{
    const BodyData& data = Data(body);
    for (b2ContactEdge* edge = data.contactList; edge; edge = edge->next)
    {
        Wake(world, *edge->other);
        Wake(world, body);
    }
    for (b2JointEdge* edge = data.jointList; edge; edge = edge->next)
    {
        Wake(world, *edge->other);
        Wake(world, body);
    }
}

bool WakesNeighbours(const BodyData& a, const BodyData& b)
{
    return (a.IsDynamic() && !a.IsAwake()) || (b.IsDynamic() && !b.IsAwake()) ||
           IsMovingPlatform(a) || IsMovingPlatform(b);
}

void WakeNeighbours(World& world, b2Body& bodyA, b2Body& bodyB)
{
    BodyData& a = Data(bodyA);
    BodyData& b = Data(bodyB);
    if (a.IsDynamic() && !a.IsAwake() && (IsPushed(b) || IsMovingPlatform(b)))
    {
        Wake(world, bodyA);
    }
    if (b.IsDynamic() && !b.IsAwake() && (IsPushed(a) || IsMovingPlatform(a)))
    {
        Wake(world, bodyB);
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

} // namespace box2d
