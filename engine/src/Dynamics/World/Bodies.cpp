// SPDX-License-Identifier: MIT
#include "Bodies.h"

#include "../Contacts/Boxes.h"
#include "../Contacts/Contacts.h"
#include "../Islands/Sleep.h"
#include "../State/Access.h"
#include "../State/BodyPose.h"
#include "../State/Reach.h"
#include "../State/World.h"
#include "Fixtures.h"
#include "Joints.h"

#include "../../Collision/MassProperties.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <new>

namespace box2d
{

namespace
{

std::uint32_t InitialFlags(const b2BodyDef& def)
{
    std::uint32_t flags = 0;
    flags |= def.awake ? kBodyAwake : 0u;
    flags |= def.allowSleep ? kBodyAutoSleep : 0u;
    flags |= def.bullet ? kBodyBullet : 0u;
    flags |= def.fixedRotation ? kBodyFixedRotation : 0u;
    flags |= def.active ? kBodyActive : 0u;
    return flags;
}

constexpr const char* kWrongType =
    "A body's type must be b2_staticBody, b2_kinematicBody or b2_dynamicBody.";

bool IsType(b2BodyType type)
{
    return type == b2_staticBody || type == b2_kinematicBody || type == b2_dynamicBody;
}

float32 Finite(float32 value, float32 otherwise)
{
    return b2IsValid(value) ? value : otherwise;
}

b2Vec2 Finite(const b2Vec2& value)
{
    return value.IsValid() ? value : b2Vec2(0.0f, 0.0f);
}

void Fill(BodyData& body, const b2BodyDef& def)
{
    body.mobility = IsType(def.type) ? static_cast<Mobility>(def.type) : Mobility::Static;
    body.flags = InitialFlags(def) & ~std::uint32_t(kBodyAwake);
    const b2Vec2 position = IsWithinReach(def.position) ? def.position : b2Vec2(0.0f, 0.0f);
    body.pose = Pose{position.x, position.y, Finite(def.angle, 0.0f)};
    body.previous = body.pose;
    if (body.mobility != Mobility::Static)
    {
        body.linearVelocity = Finite(def.linearVelocity);
        body.angularVelocity = Finite(def.angularVelocity, 0.0f);
    }
    // Infinity is a damping: nothing moves. NaN counts as 0.
    body.linearDamping = def.linearDamping >= 0.0f ? def.linearDamping : 0.0f;
    body.angularDamping = def.angularDamping >= 0.0f ? def.angularDamping : 0.0f;
    body.gravityScale = Finite(def.gravityScale, 1.0f);
    body.userData = def.userData;
    if (body.IsDynamic())
    {
        body.mass = 1.0f;
        body.invMass = 1.0f;
    }
    SynchronizePose(body);
}

bool IsSound(const b2BodyDef& def)
{
    return B2_REQUIRE(IsType(def.type), kWrongType) &&
           B2_REQUIRE(IsWithinReach(def.position) && IsWithinReach(def.angle),
                      "A body's position and angle must be finite and within 1e15 of zero: check "
                      "b2BodyDef::position and angle.") &&
           B2_REQUIRE(def.linearVelocity.IsValid() && b2IsValid(def.angularVelocity),
                      "A body's velocities must be finite: check b2BodyDef::linearVelocity and "
                      "angularVelocity.") &&
           B2_REQUIRE(def.linearDamping >= 0.0f && def.angularDamping >= 0.0f,
                      "A body's damping must be a number and not negative.") &&
           B2_REQUIRE(b2IsValid(def.gravityScale), "A body's gravity scale must be finite.");
}

} // namespace

b2Body* CreateBody(World& world, const b2BodyDef& def)
{
    (void)IsSound(def); // with asserts off, Fill replaces what is unsound
    b2Body& body = AddBody(world);
    BodyData& data = Data(body);
    data.number = world.bodyNumber++;
    world.hasBullets = world.hasBullets || def.bullet;
    Fill(data, def);
    world.inactiveCount += data.IsActive() ? 0 : 1;
    if (data.IsDynamic() && data.IsActive())
    {
        world.islands.Add(body);
    }
    if (def.awake)
    {
        Wake(world, body);
    }
    return &body;
}

b2Body& AddBody(World& world)
{
    b2Body* body = new (world.allocator.Allocate(int32(sizeof(b2Body)))) b2Body();
    BodyData& data = Data(*body);
    data.world = &world;
    data.next = world.bodyList;
    if (world.bodyList)
    {
        Data(*world.bodyList).prev = body;
    }
    world.bodyList = body;
    ++world.bodyCount;
    return *body;
}

void DestroyBody(World& world, b2Body& body)
{
    BodyData& data = Data(body);
    while (data.jointList)
    {
        DestroyJointImplicitly(world, *data.jointList->joint);
    }
    while (data.contactList)
    {
        DestroyContact(world, *data.contactList->contact);
    }
    while (data.fixtureList)
    {
        b2Fixture* fixture = data.fixtureList;
        if (world.destructionListener)
        {
            const Lock lock(world);
            world.destructionListener->SayGoodbye(fixture);
        }
        DestroyFixture(world, body, *fixture);
    }
    PutToSleep(world, body);
    world.islands.Remove(body);
    (data.prev ? Data(*data.prev).next : world.bodyList) = data.next;
    if (data.next)
    {
        Data(*data.next).prev = data.prev;
    }
    --world.bodyCount;
    world.inactiveCount -= data.IsActive() ? 0 : 1;
    body.~b2Body();
    world.allocator.Free(&body, int32(sizeof(b2Body)));
}

void SetTransform(World& world, b2Body& body, const b2Vec2& position, float32 angle)
{
    BodyData& data = Data(body);
    const auto [sine, cosine] = SinCos(double(angle));
    const double lx = data.localCenter.x;
    const double ly = data.localCenter.y;
    data.pose =
        Pose{position.x + (cosine * lx - sine * ly), position.y + (sine * lx + cosine * ly), angle};
    data.previous = data.pose;
    SynchronizePose(data);
    data.transform.p = position; // exactly what was asked for
    data.userMovedAt = world.stepNumber;
    ResetProxies(world.proxies, data);
    WakeAttached(world, body);
}

namespace
{

// Moves the centre of mass; the origin and the velocity of every point are unchanged.
void MoveCenter(BodyData& body, const b2Vec2& localCenter)
{
    const b2Vec2 shift = b2Mul(body.rotation, localCenter - body.localCenter);
    body.localCenter = localCenter;
    body.pose.x += shift.x;
    body.pose.y += shift.y;
    body.previous = body.pose;
    const b2Vec2 position = body.transform.p;
    SynchronizePose(body);
    body.transform.p = position;
    body.linearVelocity += b2Cross(body.angularVelocity, shift);
}

/// Discards results that depend on the old extents.
void ForgetExtents(BodyData& body)
{
    if (body.jointList != nullptr)
    {
        body.world->graph.NoteMasses(); // also for a change of the centre
    }
    body.room = 0.0f;
}

void Include(const b2Shape& shape, BodyData& body)
{
    const int32 children = shape.GetChildCount();
    for (int32 child = 0; child < children; ++child)
    {
        b2AABB box;
        shape.ComputeAABB(&box, b2Transform(), child);
        const b2Vec2 half = box.GetExtents();
        body.minExtent = b2Min(body.minExtent, b2Min(half.x, half.y));
        const b2Vec2 reach = b2Abs(box.GetCenter() - body.localCenter) + half;
        body.maxExtent = b2Max(body.maxExtent, reach.Length());
    }
}

} // namespace

void MeasureShapes(BodyData& body)
{
    ForgetExtents(body);
    body.minExtent = b2_maxFloat;
    body.maxExtent = 0.0f;
    for (b2Fixture* f = body.fixtureList; f; f = f->GetNext())
    {
        Include(*f->GetShape(), body);
    }
}

void MeasureNewest(BodyData& body)
{
    if (body.fixtureCount == 1)
    {
        MeasureShapes(body);
        return;
    }
    ForgetExtents(body);
    Include(*body.fixtureList->GetShape(), body);
}

namespace
{

/// Limits of masses and inertias. Within them, a mass or its inverse times a speed of kFastest is
/// at most 1e30, far within single precision, which ends at 3e38. A smaller mass counts as 1, as
/// that of a body without shapes, a smaller inertia as zero, and a larger one as the maximum.
constexpr float32 kMinMass = 1e-20f;
constexpr float32 kMaxMass = 1e20f;

void SetInertia(BodyData& body, float32 mass, float32 inertiaAboutCenter)
{
    body.mass = mass >= kMinMass ? b2Min(mass, kMaxMass) : 1.0f;
    body.invMass = 1.0f / body.mass;
    const bool turns = inertiaAboutCenter >= kMinMass && (body.flags & kBodyFixedRotation) == 0;
    body.inertia = turns ? b2Min(inertiaAboutCenter, kMaxMass) : 0.0f;
    body.invInertia = turns ? 1.0f / body.inertia : 0.0f;
}

/// Combines two rigidly connected bodies: each rotates about the common centre (parallel axis
/// theorem).
MassProperties Sum(const MassProperties& a, const MassProperties& b)
{
    MassProperties sum;
    sum.mass = a.mass + b.mass;
    const double share = b.mass / sum.mass;
    const double dx = b.centerX - a.centerX;
    const double dy = b.centerY - a.centerY;
    sum.centerX = a.centerX + share * dx;
    sum.centerY = a.centerY + share * dy;
    sum.centralInertia = a.centralInertia + b.centralInertia + share * a.mass * (dx * dx + dy * dy);
    return sum;
}

} // namespace

void SetMassData(BodyData& body, const b2MassData& massData)
{
    if (!body.IsDynamic())
    {
        return;
    }
    body.flags |= kBodyMassSet;
    // A body without mass does not rotate.
    const float32 aboutCenter = massData.I - massData.mass * massData.center.LengthSquared();
    SetInertia(body, massData.mass, massData.mass > 0.0f ? aboutCenter : 0.0f);
    MoveCenter(body, massData.center);
    MeasureShapes(body);
}

void ForgetManifolds(BodyData& body)
{
    for (b2ContactEdge* edge = body.contactList; edge; edge = edge->next)
    {
        ForgetManifold(*body.world, Data(*edge->contact));
    }
}

void ResetMassData(BodyData& body)
{
    body.flags &= ~std::uint32_t(kBodyMassSet);
    ForgetManifolds(body);
    MassProperties total;
    for (b2Fixture* f = body.fixtureList; f && body.IsDynamic(); f = f->GetNext())
    {
        if (f->GetDensity() > 0.0f)
        {
            const MassProperties part = ComputeMassProperties(*f->GetShape(), f->GetDensity());
            total = part.mass > 0.0 ? Sum(total, part) : total;
        }
    }
    if (body.IsDynamic())
    {
        SetInertia(body, float32(total.mass), float32(total.centralInertia));
    }
    else
    {
        body.mass = 0.0f;
        body.invMass = 0.0f;
        body.inertia = 0.0f;
        body.invInertia = 0.0f;
    }
    MoveCenter(body, b2Vec2(float32(total.centerX), float32(total.centerY)));
    MeasureShapes(body);
}

void SetMobility(World& world, b2Body& body, Mobility mobility)
{
    BodyData& data = Data(body);
    // Contacts and proxies of the old type are removed; the next step creates new contacts.
    while (data.contactList)
    {
        DestroyContact(world, *data.contactList->contact);
    }
    const bool wasActive = data.IsActive();
    SetActive(world, body, false);
    data.mobility = mobility;
    data.previous = data.pose;
    data.sweepStart = 0.0f;
    data.sleepTime = 0.0f;
    if (mobility == Mobility::Static)
    {
        data.linearVelocity.SetZero();
        data.angularVelocity = 0.0f;
    }
    data.force.SetZero();
    data.torque = 0.0f;
    ResetMassData(data);
    SetActive(world, body, wasActive);
    Wake(world, body);
}

void SetActive(World& world, b2Body& body, bool active)
{
    BodyData& data = Data(body);
    if (active == data.IsActive())
    {
        return;
    }
    world.inactiveCount += active ? -1 : 1;
    if (active)
    {
        data.flags |= kBodyActive;
        for (b2Fixture* f = data.fixtureList; f; f = f->GetNext())
        {
            CreateProxies(world.proxies, *f);
        }
        if (data.IsDynamic())
        {
            world.islands.Add(body);
        }
    }
    else
    {
        while (data.contactList)
        {
            DestroyContact(world, *data.contactList->contact);
        }
        for (b2Fixture* f = data.fixtureList; f; f = f->GetNext())
        {
            DestroyProxies(world.proxies, *f);
        }
        WakeAttached(world, body); // what hung from it falls
        data.force.SetZero();
        data.torque = 0.0f;
        data.flags &= ~std::uint32_t(kBodyActive);
        world.islands.Remove(body);
    }
    UpdateActivity(world, body);
}

} // namespace box2d
