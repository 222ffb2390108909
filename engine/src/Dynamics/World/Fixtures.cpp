// SPDX-License-Identifier: MIT
#include "../Contacts/Sweeps.h"
#include "../State/Access.h"
#include "../State/Reach.h"
#include "../State/World.h"

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

/// Returns the margin of a box in the tree [m]: the manual's for shapes of a few metres. Smaller
/// shapes have less, because their margins would overlap those of all neighbours.
float32 Margin(const b2AABB& box)
{
    const b2Vec2 half = box.GetExtents();
    return b2Min(b2_aabbExtension, 0.25f * b2Max(half.x, half.y));
}

b2AABB Fatten(const b2AABB& box, const b2Vec2& displacement)
{
    const float32 margin = Margin(box);
    const b2Vec2 ahead = b2_aabbMultiplier * displacement;
    b2AABB fat;
    fat.lowerBound = box.lowerBound - b2Vec2(margin, margin) + b2Min(ahead, b2Vec2(0.0f, 0.0f));
    fat.upperBound = box.upperBound + b2Vec2(margin, margin) + b2Max(ahead, b2Vec2(0.0f, 0.0f));
    return fat;
}

/// Returns the box of a bullet's path: later impacts do not matter.
b2AABB Widen(const b2AABB& box, float32 minExtent)
{
    const float32 margin = b2Min(b2_aabbExtension, 0.25f * minExtent);
    b2AABB wide;
    wide.lowerBound = box.lowerBound - b2Vec2(margin, margin);
    wide.upperBound = box.upperBound + b2Vec2(margin, margin);
    return wide;
}

/// True for a single circle about the centre of mass, whose rotation has no effect.
bool IsRound(const BodyData& body)
{
    const b2Fixture* f = body.fixtureList;
    return f != nullptr && f->GetNext() == nullptr && f->GetType() == b2Shape::e_circle &&
           static_cast<const b2CircleShape*>(f->GetShape())->m_p == b2Vec2(0.0f, 0.0f) &&
           body.localCenter == b2Vec2(0.0f, 0.0f);
}

/// Returns the body's transform at the start of its path, as needed for its boxes.
b2Transform TransformBefore(const BodyData& body)
{
    if (IsRound(body))
    {
        const b2Vec2 center(float32(body.previous.x), float32(body.previous.y));
        return b2Transform(center, body.rotation);
    }
    BodyData start;
    start.pose = body.previous;
    start.localCenter = body.localCenter;
    SynchronizePose(start);
    return start.transform;
}

/// Returns the box of a shape at the current and, if given, an earlier transform. A corner may
/// leave both in a wide rotation.
b2AABB BoxOnItsWay(const b2Shape& shape, int32 child, const BodyData& body,
                   const b2Transform* before)
{
    if (before != nullptr && !IsRound(body) && IsWide(body.pose.angle - body.previous.angle))
    {
        return BoxOfWay(b2Mul(*before, body.localCenter), body.worldCenter, body.maxExtent);
    }
    b2AABB box;
    shape.ComputeAABB(&box, body.transform, child);
    if (before != nullptr)
    {
        b2AABB boxBefore;
        shape.ComputeAABB(&boxBefore, *before, child);
        box.Combine(boxBefore);
    }
    return box;
}

/// Returns how far the inner box may move in any direction within the outer one [m].
float32 RoomIn(const b2AABB& outer, const b2AABB& inner)
{
    const b2Vec2 below = inner.lowerBound - outer.lowerBound;
    const b2Vec2 above = outer.upperBound - inner.upperBound;
    const b2Vec2 least = b2Min(below, above);
    return b2Min(least.x, least.y);
}

/// Returns an upper bound of the rounding error of boxes in single precision, over a few operations
/// [m].
float32 BoxRounding(const BodyData& body)
{
    constexpr float32 operations = 16.0f;
    const float32 farthest = b2Abs(body.worldCenter.x) + b2Abs(body.worldCenter.y) + body.maxExtent;
    return operations * b2_epsilon * farthest;
}

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

} // namespace

b2Fixture* World::CreateFixture(b2Body& body, const b2FixtureDef& def)
{
    if (!B2_REQUIRE(def.shape != nullptr, "A fixture needs a shape: set b2FixtureDef::shape.") ||
        !IsSound(*def.shape))
    {
        return nullptr;
    }
    (void)IsSound(def); // with asserts off, invalid values become zero
    b2Fixture* fixture = &AddFixture(body, *def.shape);
    FixtureAccess::Density(*fixture) = NotNegative(def.density);
    FixtureAccess::Friction(*fixture) = NotNegative(def.friction);
    FixtureAccess::Restitution(*fixture) = NotNegative(def.restitution);
    FixtureAccess::Filter(*fixture) = def.filter;
    FixtureAccess::IsSensor(*fixture) = def.isSensor;
    fixture->SetUserData(def.userData);
    BodyData& data = Data(body);
    if (data.IsActive())
    {
        CreateProxies(*fixture);
    }
    // A fixture without mass does not change the mass data, so a user override remains.
    fixture->GetDensity() > 0.0f ? ResetMassData(data) : MeasureNewest(data);
    return fixture;
}

b2Fixture& World::AddFixture(b2Body& body, const b2Shape& shape)
{
    b2Fixture* fixture = FixtureAccess::Construct(allocator.Allocate(int32(sizeof(b2Fixture))));
    FixtureAccess::Shape(*fixture) = shape.Clone(&allocator);
    FixtureAccess::Body(*fixture) = &body;
    auto* proxyArray = static_cast<b2FixtureProxy*>(allocator.Allocate(ProxyBytes(*fixture)));
    for (int32 child = 0; child < fixture->GetShape()->GetChildCount(); ++child)
    {
        new (proxyArray + child) b2FixtureProxy();
    }
    FixtureAccess::Proxies(*fixture) = proxyArray;
    BodyData& data = Data(body);
    FixtureAccess::Next(*fixture) = data.fixtureList;
    data.fixtureList = fixture;
    ++data.fixtureCount;
    return *fixture;
}

void World::DestroyFixture(b2Body& body, b2Fixture& fixture)
{
    BodyData& data = Data(body);
    for (b2ContactEdge* edge = data.contactList; edge;)
    {
        b2Contact* contact = edge->contact;
        edge = edge->next;
        if (contact->GetFixtureA() == &fixture || contact->GetFixtureB() == &fixture)
        {
            DestroyContact(*contact);
        }
    }
    DestroyProxies(fixture);

    b2Fixture** link = &data.fixtureList;
    while (*link != &fixture)
    {
        link = &FixtureAccess::Next(**link);
    }
    *link = fixture.GetNext();
    --data.fixtureCount;

    FreeFixture(fixture);
    ResetMassData(data);
}

void World::FreeFixture(b2Fixture& fixture)
{
    allocator.Free(FixtureAccess::Proxies(fixture), ProxyBytes(fixture));
    b2Shape* shape = fixture.GetShape();
    const int32 bytes = SizeOf(*shape);
    shape->~b2Shape();
    allocator.Free(shape, bytes);
    FixtureAccess::Destruct(fixture);
    allocator.Free(&fixture, int32(sizeof(b2Fixture)));
}

void World::CreateProxies(b2Fixture& fixture)
{
    BodyData& body = Data(*fixture.GetBody());
    body.room = 0.0f;
    b2Shape* shape = fixture.GetShape();
    for (int32 child = 0; child < shape->GetChildCount(); ++child)
    {
        b2FixtureProxy& proxy = FixtureAccess::Proxies(fixture)[child];
        proxy.fixture = &fixture;
        proxy.childIndex = child;
        b2AABB box;
        shape->ComputeAABB(&box, body.transform, child);
        proxy.aabb = Fatten(box, b2Vec2(0.0f, 0.0f));
        proxy.proxyId =
            proxies.Create(proxy.aabb, body.mobility, &proxy, fixture.GetFilterData().categoryBits);
    }
    FixtureAccess::ProxyCount(fixture) = shape->GetChildCount();
}

void World::DestroyProxies(b2Fixture& fixture)
{
    for (int32 child = 0; child < FixtureAccess::ProxyCount(fixture); ++child)
    {
        b2FixtureProxy& proxy = FixtureAccess::Proxies(fixture)[child];
        proxies.Destroy(proxy.proxyId);
        proxy.proxyId = -1;
    }
    FixtureAccess::ProxyCount(fixture) = 0;
}

void World::UpdateProxies(BodyData& body, bool swept)
{
    if (swept && (body.flags & kBodySwept) != 0)
    {
        GrowBoxes(body);
    }
    else if (RefreshBoxes(body, swept))
    {
        MoveProxies(body);
    }
}

bool World::RefreshBoxes(BodyData& body, bool swept)
{
    const bool bullet = swept && (body.flags & kBodyBullet) != 0;
    // The boxes of a bullet's path are valid for one step.
    const bool anew = bullet || (body.flags & kBodySwept) != 0;
    bool left = anew;
    b2Transform before;
    float32 room = b2_maxFloat;
    b2Vec2 displacement(0.0f, 0.0f);
    displacement.x = float32(body.pose.x - body.previous.x);
    displacement.y = float32(body.pose.y - body.previous.y);
    if (swept)
    {
        before = TransformBefore(body);
    }
    for (b2Fixture* f = body.fixtureList; f; f = f->GetNext())
    {
        for (int32 child = 0; child < FixtureAccess::ProxyCount(*f); ++child)
        {
            b2FixtureProxy& proxy = FixtureAccess::Proxies(*f)[child];
            const b2AABB box = BoxOnItsWay(*f->GetShape(), child, body, swept ? &before : nullptr);
            if (anew || !proxy.aabb.Contains(box))
            {
                proxy.aabb = bullet ? Widen(box, body.minExtent) : Fatten(box, displacement);
                left = true;
            }
            room = b2Min(room, RoomIn(proxy.aabb, box));
        }
    }
    body.flags = bullet ? body.flags | kBodySwept : body.flags & ~std::uint32_t(kBodySwept);
    body.room = bullet ? 0.0f : room - BoxRounding(body);
    return left;
}

/// Call after an impact: extends the boxes to the rest of the path.
void World::GrowBoxes(BodyData& body)
{
    const b2Transform before = TransformBefore(body);
    for (b2Fixture* f = body.fixtureList; f; f = f->GetNext())
    {
        for (int32 child = 0; child < FixtureAccess::ProxyCount(*f); ++child)
        {
            b2FixtureProxy& proxy = FixtureAccess::Proxies(*f)[child];
            proxy.aabb.Combine(
                Widen(BoxOnItsWay(*f->GetShape(), child, body, &before), body.minExtent));
            proxies.Grow(proxy.proxyId, proxy.aabb);
        }
    }
}

void World::MoveProxies(BodyData& body)
{
    for (b2Fixture* f = body.fixtureList; f; f = f->GetNext())
    {
        for (int32 child = 0; child < FixtureAccess::ProxyCount(*f); ++child)
        {
            const b2FixtureProxy& proxy = FixtureAccess::Proxies(*f)[child];
            const b2AABB& known = proxies.FatBox(proxy.proxyId);
            if (known.lowerBound != proxy.aabb.lowerBound ||
                known.upperBound != proxy.aabb.upperBound)
            {
                proxies.Move(proxy.proxyId, proxy.aabb);
            }
        }
    }
}

void World::ResetProxies(BodyData& body)
{
    body.flags &= ~std::uint32_t(kBodySwept);
    for (b2Fixture* f = body.fixtureList; f; f = f->GetNext())
    {
        for (int32 child = 0; child < FixtureAccess::ProxyCount(*f); ++child)
        {
            b2FixtureProxy& proxy = FixtureAccess::Proxies(*f)[child];
            b2AABB box;
            f->GetShape()->ComputeAABB(&box, body.transform, child);
            proxy.aabb = Fatten(box, b2Vec2(0.0f, 0.0f));
            proxies.Move(proxy.proxyId, proxy.aabb);
        }
    }
}

void World::Refilter(b2Fixture& fixture)
{
    b2Body* body = fixture.GetBody();
    for (b2ContactEdge* edge = body->GetContactList(); edge; edge = edge->next)
    {
        if (edge->contact->GetFixtureA() == &fixture || edge->contact->GetFixtureB() == &fixture)
        {
            Data(*edge->contact).flags |= kContactFilter;
            filtersChanged = true;
        }
    }
    for (int32 child = 0; child < FixtureAccess::ProxyCount(fixture); ++child)
    {
        proxies.SetCategories(FixtureAccess::Proxies(fixture)[child].proxyId,
                              fixture.GetFilterData().categoryBits);
        proxies.Touch(FixtureAccess::Proxies(fixture)[child].proxyId);
    }
}

void World::UpdateSensor(b2Fixture& fixture)
{
    for (b2ContactEdge* edge = fixture.GetBody()->GetContactList(); edge; edge = edge->next)
    {
        ContactData& c = Data(*edge->contact);
        const bool sensor = c.fixtureA->IsSensor() || c.fixtureB->IsSensor();
        if (sensor != c.IsSensor())
        {
            c.flags ^= kContactSensor;
            ForgetUpdate(c); // cancel the update: the type of contact changes
            c.flags &= ~std::uint32_t(kContactKept);
            UpdateActivity(*edge->contact);
            Wake(*c.bodyA);
            Wake(*c.bodyB);
        }
    }
}

} // namespace box2d
