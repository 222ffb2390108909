// SPDX-License-Identifier: MIT
#include "Fixtures.h"

#include "../Contacts/Boxes.h"
#include "../Contacts/Contacts.h"
#include "../Islands/Sleep.h"
#include "../State/Access.h"
#include "../State/Reach.h"
#include "../State/World.h"
#include "Bodies.h"

#include <Box2D/Collision/Shapes/b2ChainShape.h>
#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>
#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <new>

namespace box2d
{

namespace
{

float32 NotNegative(float32 value)
{
    return b2IsValid(value) && value > 0.0f ? value : 0.0f;
}

bool IsSound(const b2FixtureDef& def)
{
    return B2_REQUIRE(b2IsValid(def.density) && def.density >= 0.0f,
                      "A fixture's density must be finite and not negative.") &&
           B2_REQUIRE(b2IsValid(def.friction) && def.friction >= 0.0f,
                      "A fixture's friction must be finite and not negative.") &&
           B2_REQUIRE(b2IsValid(def.restitution) && def.restitution >= 0.0f,
                      "A fixture's restitution must be finite and not negative.");
}

/// True for a finite position and size.
bool IsSound(const b2Shape& shape)
{
    bool sound = shape.GetChildCount() > 0;
    if (shape.GetType() == b2Shape::e_polygon)
    {
        const auto& polygon = static_cast<const b2PolygonShape&>(shape);
        sound = polygon.GetVertexCount() >= 3;
        for (int32 i = 0; i < polygon.GetVertexCount(); ++i)
        {
            sound = sound && IsWithinReach(polygon.GetVertex(i));
        }
    }
    if (shape.GetType() == b2Shape::e_edge)
    {
        const auto& edge = static_cast<const b2EdgeShape&>(shape); // a box hides what is no number
        sound = IsWithinReach(edge.m_vertex1) && IsWithinReach(edge.m_vertex2);
    }
    for (int32 child = 0; sound && child < shape.GetChildCount(); ++child)
    {
        b2AABB box;
        shape.ComputeAABB(&box, b2Transform(), child);
        sound = box.IsValid() && IsWithinReach(box.lowerBound) && IsWithinReach(box.upperBound);
    }
    return B2_REQUIRE(sound, "A fixture's shape needs points or a radius, all of them finite and "
                             "within 1e15 m, and the radius not negative.");
}

int32 ProxyBytes(b2Fixture& fixture)
{
    return fixture.GetShape()->GetChildCount() * int32(sizeof(b2FixtureProxy));
}

/// Gives each child of the shape a proxy that is in no tree.
void AllocateProxies(b2BlockAllocator& allocator, b2Fixture& fixture)
{
    auto* proxyArray = static_cast<b2FixtureProxy*>(allocator.Allocate(ProxyBytes(fixture)));
    for (int32 child = 0; child < fixture.GetShape()->GetChildCount(); ++child)
    {
        new (proxyArray + child) b2FixtureProxy();
    }
    FixtureAccess::Proxies(fixture) = proxyArray;
}

void DestroyContactsOf(World& world, const b2Fixture& fixture)
{
    for (b2ContactEdge* edge = Data(*fixture.GetBody()).contactList; edge;)
    {
        b2Contact* contact = edge->contact;
        edge = edge->next;
        if (contact->GetFixtureA() == &fixture || contact->GetFixtureB() == &fixture)
        {
            DestroyContact(world, *contact);
        }
    }
}

int32 SizeOf(const b2Shape& shape)
{
    switch (shape.GetType())
    {
    case b2Shape::e_circle:
        return int32(sizeof(b2CircleShape));
    case b2Shape::e_edge:
        return int32(sizeof(b2EdgeShape));
    case b2Shape::e_polygon:
        return int32(sizeof(b2PolygonShape));
    default:
        return int32(sizeof(b2ChainShape));
    }
}

void FreeShape(b2BlockAllocator& allocator, b2Shape& shape)
{
    const int32 bytes = SizeOf(shape);
    shape.~b2Shape();
    allocator.Free(&shape, bytes);
}

} // namespace

b2Fixture* CreateFixture(World& world, b2Body& body, const b2FixtureDef& def)
{
    if (!B2_REQUIRE(def.shape != nullptr, "A fixture needs a shape: set b2FixtureDef::shape.") ||
        !IsSound(*def.shape))
    {
        return nullptr;
    }
    (void)IsSound(def); // with asserts off, what is unsound becomes zero
    b2Fixture* fixture = &AddFixture(world, body, *def.shape);
    FixtureAccess::Density(*fixture) = NotNegative(def.density);
    FixtureAccess::Friction(*fixture) = NotNegative(def.friction);
    FixtureAccess::Restitution(*fixture) = NotNegative(def.restitution);
    FixtureAccess::Filter(*fixture) = def.filter;
    FixtureAccess::IsSensor(*fixture) = def.isSensor;
    fixture->SetUserData(def.userData);
    BodyData& data = Data(body);
    if (data.IsActive())
    {
        CreateProxies(world.proxies, *fixture);
    }
    // Without a density it changes no mass, so one that SetMassData has set stays.
    fixture->GetDensity() > 0.0f ? ResetMassData(data) : MeasureNewest(data);
    return fixture;
}

b2Fixture& AddFixture(World& world, b2Body& body, const b2Shape& shape)
{
    b2Fixture* fixture =
        FixtureAccess::Construct(world.allocator.Allocate(int32(sizeof(b2Fixture))));
    FixtureAccess::Shape(*fixture) = shape.Clone(&world.allocator);
    FixtureAccess::Body(*fixture) = &body;
    AllocateProxies(world.allocator, *fixture);
    BodyData& data = Data(body);
    FixtureAccess::Next(*fixture) = data.fixtureList;
    data.fixtureList = fixture;
    ++data.fixtureCount;
    return *fixture;
}

void DestroyFixture(World& world, b2Body& body, b2Fixture& fixture)
{
    BodyData& data = Data(body);
    DestroyContactsOf(world, fixture);
    DestroyProxies(world.proxies, fixture);

    b2Fixture** link = &data.fixtureList;
    while (*link != &fixture)
    {
        link = &FixtureAccess::Next(**link);
    }
    *link = fixture.GetNext();
    --data.fixtureCount;

    FreeFixture(world.allocator, fixture);
    ResetMassData(data);
}

void FreeFixture(b2BlockAllocator& allocator, b2Fixture& fixture)
{
    allocator.Free(FixtureAccess::Proxies(fixture), ProxyBytes(fixture));
    FreeShape(allocator, *fixture.GetShape());
    FixtureAccess::Destruct(fixture);
    allocator.Free(&fixture, int32(sizeof(b2Fixture)));
}

bool SetShape(World& world, b2Fixture& fixture, const b2Shape& shape)
{
    if (!B2_REQUIRE(shape.GetType() == fixture.GetType(),
                    "b2Fixture::SetShape needs a shape of the same type.") ||
        !IsSound(shape))
    {
        return false;
    }
    BodyData& data = Data(*fixture.GetBody());
    b2Shape* replaced = fixture.GetShape();
    b2Shape* copy = shape.Clone(&world.allocator);
    const bool sameChildren = copy->GetChildCount() == replaced->GetChildCount();
    if (!sameChildren)
    {
        DestroyContactsOf(world, fixture);
        DestroyProxies(world.proxies, fixture);
        world.allocator.Free(FixtureAccess::Proxies(fixture), ProxyBytes(fixture));
    }
    FixtureAccess::Shape(fixture) = copy;
    FreeShape(world.allocator, *replaced);
    MeasureShapes(data);
    data.userMovedAt = world.stepNumber;
    if (!sameChildren)
    {
        AllocateProxies(world.allocator, fixture);
        if (data.IsActive())
        {
            CreateProxies(world.proxies, fixture);
        }
        return true;
    }
    ResetProxies(world.proxies, data);
    ForgetManifolds(data);
    return true;
}

void Refilter(World& world, b2Fixture& fixture)
{
    b2Body* body = fixture.GetBody();
    for (b2ContactEdge* edge = body->GetContactList(); edge; edge = edge->next)
    {
        if (edge->contact->GetFixtureA() == &fixture || edge->contact->GetFixtureB() == &fixture)
        {
            Data(*edge->contact).flags |= kContactFilter;
            world.filtersChanged = true;
        }
    }
    for (int32 child = 0; child < FixtureAccess::ProxyCount(fixture); ++child)
    {
        world.proxies.SetCategories(FixtureAccess::Proxies(fixture)[child].proxyId,
                                    fixture.GetFilterData().categoryBits);
        world.proxies.Touch(FixtureAccess::Proxies(fixture)[child].proxyId);
    }
}

void UpdateSensor(World& world, b2Fixture& fixture)
{
    for (b2ContactEdge* edge = fixture.GetBody()->GetContactList(); edge; edge = edge->next)
    {
        ContactData& c = Data(*edge->contact);
        const bool sensor = c.FixtureA()->IsSensor() || c.FixtureB()->IsSensor();
        if (sensor != c.IsSensor())
        {
            c.flags ^= kContactSensor;
            ForgetUpdate(world, c); // it is to be computed as something else
            ForgetManifold(world, c);
            UpdateActivity(world, *edge->contact);
            Wake(world, *c.bodyA);
            Wake(world, *c.bodyB);
        }
    }
}

} // namespace box2d
