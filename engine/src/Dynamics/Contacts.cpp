// SPDX-License-Identifier: MIT
#include "Narrowphase.h"
#include "Solver.h"
#include "World.h"

#include "Access.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <new>

namespace box2d
{

namespace
{

void PushEdge(b2ContactEdge& edge, b2Contact& contact, b2Body& body, b2Body& other)
{
    BodyData& data = Data(body);
    edge.contact = &contact;
    edge.other = &other;
    edge.next = data.contactList;
    if (data.contactList)
    {
        data.contactList->prev = &edge;
    }
    data.contactList = &edge;
}

void RemoveEdge(b2ContactEdge& edge, b2Body& body)
{
    (edge.prev ? edge.prev->next : Data(body).contactList) = edge.next;
    if (edge.next)
    {
        edge.next->prev = edge.prev;
    }
}

/// A joint between them says whether its two bodies collide.
bool JointForbids(b2Body& a, const b2Body& b)
{
    for (b2JointEdge* edge = a.GetJointList(); edge; edge = edge->next)
    {
        if (edge->other == &b && !edge->joint->GetCollideConnected())
        {
            return true;
        }
    }
    return false;
}

const b2FixtureProxy& ProxyA(const ContactData& c)
{
    return FixtureAccess::Proxies(*c.fixtureA)[c.childA];
}

const b2FixtureProxy& ProxyB(const ContactData& c)
{
    return FixtureAccess::Proxies(*c.fixtureB)[c.childB];
}

/// Points that touch with the same features keep their impulses, to start the solver from.
void CarryImpulses(b2Manifold& manifold, const b2Manifold& old)
{
    for (int32 i = 0; i < manifold.pointCount; ++i)
    {
        b2ManifoldPoint& point = manifold.points[i];
        point.normalImpulse = 0.0f;
        point.tangentImpulse = 0.0f;
        for (int32 j = 0; j < old.pointCount; ++j)
        {
            if (old.points[j].id.key == point.id.key)
            {
                point.normalImpulse = old.points[j].normalImpulse;
                point.tangentImpulse = old.points[j].tangentImpulse;
                break;
            }
        }
    }
}

/// The older body's fixture comes first, whichever of the two moved.
b2Contact* MakeContact(World& world, const b2FixtureProxy& one, const b2FixtureProxy& another)
{
    const bool inOrder =
        Data(*one.fixture->GetBody()).number < Data(*another.fixture->GetBody()).number;
    const b2FixtureProxy& first = inOrder ? one : another;
    const b2FixtureProxy& second = inOrder ? another : one;
    const bool swap = MustSwap(first.fixture->GetType(), second.fixture->GetType());
    const b2FixtureProxy& a = swap ? second : first;
    const b2FixtureProxy& b = swap ? first : second;

    b2Contact* contact = new (world.allocator.Allocate(int32(sizeof(b2Contact)))) b2Contact();
    ContactData& c = Data(*contact);
    c.fixtureA = a.fixture;
    c.fixtureB = b.fixture;
    c.childA = a.childIndex;
    c.childB = b.childIndex;
    c.bodyA = a.fixture->GetBody();
    c.bodyB = b.fixture->GetBody();
    c.flags =
        kContactEnabled | (a.fixture->IsSensor() || b.fixture->IsSensor() ? kContactSensor : 0u);
    contact->ResetFriction();
    contact->ResetRestitution();

    PushEdge(c.edgeA, *contact, *c.bodyA, *c.bodyB);
    PushEdge(c.edgeB, *contact, *c.bodyB, *c.bodyA);
    c.next = world.contactList;
    if (world.contactList)
    {
        Data(*world.contactList).prev = contact;
    }
    world.contactList = contact;
    ++world.contactCount;
    return contact;
}

} // namespace

bool World::ShouldCollide(b2Fixture& fixtureA, b2Fixture& fixtureB) const
{
    b2Body& a = *fixtureA.GetBody();
    b2Body& b = *fixtureB.GetBody();
    return &a != &b && (Data(a).IsDynamic() || Data(b).IsDynamic()) && !JointForbids(a, b) &&
           filter->ShouldCollide(&fixtureA, &fixtureB);
}

void World::FindNewContacts()
{
    proxies.FindPairs([this](b2FixtureProxy* a, b2FixtureProxy* b) {
        if (!CanCollide(a->fixture->GetType(), b->fixture->GetType()) ||
            pairs.Contains(a->proxyId, b->proxyId) || !ShouldCollide(*a->fixture, *b->fixture))
        {
            return;
        }
        pairs.Insert(a->proxyId, b->proxyId);
        b2Contact* contact = MakeContact(*this, *a, *b);
        UpdateActivity(*contact);
        // What was moved by hand into something asleep would else never be looked at.
        if (Data(*contact).awakeIndex == -1)
        {
            Wake(*(Data(*a->fixture->GetBody()).IsDynamic() ? a : b)->fixture->GetBody());
        }
    });
}

void World::UpdateContacts()
{
    if (filtersChanged)
    {
        filtersChanged = false;
        for (b2Contact* contact = contactList; contact;)
        {
            b2Contact* next = contact->GetNext();
            ContactData& c = Data(*contact);
            if ((c.flags & kContactFilter) != 0 && !ShouldCollide(*c.fixtureA, *c.fixtureB))
            {
                DestroyContact(*contact);
            }
            else
            {
                c.flags &= ~std::uint32_t(kContactFilter);
            }
            contact = next;
        }
    }
    // The list changes under the loop: a contact that goes is replaced by the last one, those that
    // wake are appended and updated as well.
    for (std::size_t i = 0; i < awakeContacts.size();)
    {
        b2Contact* contact = awakeContacts[i];
        const ContactData& c = Data(*contact);
        if (b2TestOverlap(ProxyA(c).aabb, ProxyB(c).aabb))
        {
            UpdateContact(*contact);
            ++i;
        }
        else
        {
            DestroyContact(*contact);
        }
    }
}

void World::UpdateContact(b2Contact& contact)
{
    ContactData& c = Data(contact);
    const BodyData& a = Data(*c.bodyA);
    const BodyData& b = Data(*c.bodyB);
    const b2Manifold old = c.manifold;
    const bool wasTouching = c.IsTouching();
    const b2Transform bInA = RelativeTransform(a, b);
    c.radiusA = c.fixtureA->GetShape()->m_radius;
    c.radiusB = c.fixtureB->GetShape()->m_radius;

    c.flags |= kContactEnabled;
    bool touching = false;
    if (c.IsSensor())
    {
        touching = b2TestOverlap(c.fixtureA->GetShape(), c.childA, c.fixtureB->GetShape(), c.childB,
                                 b2Transform(), bInA);
        c.manifold.pointCount = 0;
    }
    else
    {
        Collide(&c.manifold, *c.fixtureA->GetShape(), c.childA, *c.fixtureB->GetShape(), c.childB,
                bInA);
        CarryImpulses(c.manifold, old);
        touching = c.manifold.pointCount > 0;
    }

    if (touching != wasTouching)
    {
        c.flags ^= kContactTouching;
        if (!c.IsSensor())
        {
            Wake(*c.bodyA);
            Wake(*c.bodyB);
        }
        UpdateActivity(contact);
        if (listener)
        {
            touching ? listener->BeginContact(&contact) : listener->EndContact(&contact);
        }
    }
    if (touching && !c.IsSensor())
    {
        WakeNeighbours(*c.bodyA, *c.bodyB);
        if (listener)
        {
            listener->PreSolve(&contact, &old);
        }
    }
}

void World::DestroyContact(b2Contact& contact)
{
    ContactData& c = Data(contact);
    if (c.IsTouching())
    {
        if (listener)
        {
            const Lock lock(*this);
            listener->EndContact(&contact);
        }
        c.flags &= ~std::uint32_t(kContactTouching);
        if (!c.IsSensor())
        {
            Wake(*c.bodyA);
            Wake(*c.bodyB);
        }
        UpdateActivity(contact);
    }
    if (c.awakeIndex != -1)
    {
        b2Contact* last = awakeContacts.back();
        awakeContacts[std::size_t(c.awakeIndex)] = last;
        Data(*last).awakeIndex = c.awakeIndex;
        awakeContacts.pop_back();
    }
    pairs.Erase(ProxyA(c).proxyId, ProxyB(c).proxyId);
    RemoveEdge(c.edgeA, *c.bodyA);
    RemoveEdge(c.edgeB, *c.bodyB);
    (c.prev ? Data(*c.prev).next : contactList) = c.next;
    if (c.next)
    {
        Data(*c.next).prev = c.prev;
    }
    --contactCount;
    contact.~b2Contact();
    allocator.Free(&contact, int32(sizeof(b2Contact)));
}

} // namespace box2d
