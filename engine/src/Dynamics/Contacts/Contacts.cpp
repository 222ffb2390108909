// SPDX-License-Identifier: MIT
#include "../State/World.h"
#include "Narrowphase.h"
#include "ReadAhead.h"
#include "Sweeps.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <new>

namespace box2d
{

namespace
{

constexpr int32 kContactGrain = 32; ///< contacts per part of a parallel loop

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

/// True if a joint disables collision between the two bodies.
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

/// Copies the impulses of points with the same features, to warm start the solver.
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

/// A manifold is recomputed when a body has moved by more than this relative to the other [m]. It
/// is stored in the bodies' frames: points keep their position on the face, and overlap and normal
/// follow the current pose. Far below the slop, and a small fraction of a small body.
constexpr float32 kStill = 0.1f * b2_linearSlop;
constexpr float32 kStillShare = 0.005f;

bool IsKept(const ContactData& c, const b2Transform& bInA)
{
    if ((c.flags & kContactKept) == 0 || c.manifold.pointCount == 0) // emptied by a callback
    {
        return false;
    }
    const float32 reach = Data(*c.bodyB).maxExtent;
    const float32 still = b2Min(kStill, kStillShare * reach);
    const b2Vec2 moved = b2Abs(bInA.p - c.relative.p);
    const float32 turned =
        b2Max(b2Abs(bInA.q.s - c.relative.q.s), b2Abs(bInA.q.c - c.relative.q.c));
    return b2Max(moved.x, moved.y) + turned * reach <= still;
}

bool IsSame(const b2Manifold& a, const b2Manifold& b)
{
    bool same = a.type == b.type && a.pointCount == b.pointCount &&
                a.localNormal == b.localNormal && a.localPoint == b.localPoint;
    for (int32 i = 0; i < b2Min(a.pointCount, b.pointCount); ++i)
    {
        same = same && a.points[i].localPoint == b.points[i].localPoint;
    }
    return same;
}

/// The older body's fixture comes first, independent of which one moved.
b2Contact* MakeContact(World& world, const b2FixtureProxy& one, const b2FixtureProxy& another)
{
    const bool inOrder =
        Data(*one.fixture->GetBody()).number < Data(*another.fixture->GetBody()).number;
    const b2FixtureProxy& first = inOrder ? one : another;
    const b2FixtureProxy& second = inOrder ? another : one;
    const bool swap = MustSwap(first.fixture->GetType(), second.fixture->GetType());
    const b2FixtureProxy& a = swap ? second : first;
    const b2FixtureProxy& b = swap ? first : second;

    b2Contact& contact = world.AddContact(a, b);
    ContactData& c = Data(contact);
    c.flags = kContactEnabled |
              (a.fixture->IsSensor() || b.fixture->IsSensor() ? kContactSensor : 0u) |
              (Data(*c.bodyA).IsDynamic() && Data(*c.bodyB).IsDynamic() ? 0u : kContactObstacle);
    contact.ResetFriction();
    contact.ResetRestitution();
    return &contact;
}

} // namespace

b2Contact& World::AddContact(const b2FixtureProxy& a, const b2FixtureProxy& b)
{
    b2Contact* contact = new (allocator.Allocate(int32(sizeof(b2Contact)))) b2Contact();
    ContactData& c = Data(*contact);
    c.fixtureA = a.fixture;
    c.fixtureB = b.fixture;
    c.childA = a.childIndex;
    c.childB = b.childIndex;
    c.bodyA = a.fixture->GetBody();
    c.bodyB = b.fixture->GetBody();
    PushEdge(c.edgeA, *contact, *c.bodyA, *c.bodyB);
    PushEdge(c.edgeB, *contact, *c.bodyB, *c.bodyA);
    c.next = contactList;
    if (contactList)
    {
        Data(*contactList).prev = contact;
    }
    contactList = contact;
    ++contactCount;
    pairs.Insert(a.proxyId, b.proxyId);
    return *contact;
}

bool World::ShouldCollide(b2Fixture& fixtureA, b2Fixture& fixtureB) const
{
    b2Body& a = *fixtureA.GetBody();
    b2Body& b = *fixtureB.GetBody();
    return &a != &b && (Data(a).IsDynamic() || Data(b).IsDynamic()) && !JointForbids(a, b) &&
           filter->ShouldCollide(&fixtureA, &fixtureB);
}

void World::FindNewContacts()
{
    const auto isKnown = [this](const b2FixtureProxy* a, const b2FixtureProxy* b) {
        return !CanCollide(a->fixture->GetType(), b->fixture->GetType()) ||
               !WaysMeet(Data(*a->fixture->GetBody()), *a->fixture->GetShape(), a->childIndex,
                         Data(*b->fixture->GetBody()), *b->fixture->GetShape(), b->childIndex) ||
               pairs.Contains(a->proxyId, b->proxyId);
    };
    // Pairs that the default filter always rejects are not collected.
    const bool filtersByCategory = filter == &defaultFilter;
    const auto isWanted = [this, filtersByCategory](const b2FixtureProxy* moved,
                                                    Mobility mobility) {
        const b2Filter& own = moved->fixture->GetFilterData();
        return !filtersByCategory || own.groupIndex != 0 || proxies.MayMeet(own.maskBits, mobility);
    };
    proxies.FindPairs(
        threads.get(), isWanted, isKnown, [this](b2FixtureProxy* a, b2FixtureProxy* b) {
            if (!ShouldCollide(*a->fixture, *b->fixture))
            {
                return; // the program's filter must be called on its thread
            }
            b2Contact* contact = MakeContact(*this, *a, *b);
            UpdateActivity(*contact);
            // A body moved by the user into a sleeping one would otherwise never be tested.
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
    // Without a listener most contacts need only the first phase.
    ComputeContacts() && listener == nullptr ? FinishContactsInNeed() : FinishContacts();
}

/// The first phase of all updates, on all threads. With one thread and no listener each contact is
/// completed in turn instead, and this returns false. Results are the same, because poses do not
/// change.
bool World::ComputeContacts()
{
    const bool keepOld = listener != nullptr;
    if (!threads && !keepOld)
    {
        return false;
    }
    oldManifolds.resize(keepOld ? awakeContacts.size() : 0);
    attention.resize(awakeContacts.size());
    ParallelFor(threads.get(), int32(awakeContacts.size()), kContactGrain,
                [&](int32 begin, int32 end) {
                    b2Manifold unused;
                    for (int32 i = begin; i < end; ++i)
                    {
                        ReadAhead(awakeContacts, std::size_t(i));
                        b2Contact& contact = *awakeContacts[std::size_t(i)];
                        Data(contact).oldIndex = i;
                        ComputeContact(contact, keepOld ? oldManifolds[std::size_t(i)] : unused);
                        attention[std::size_t(i)] = NeedsAttention(contact);
                    }
                });
    return true;
}

/// True if the first phase of an update requires more than that the contact takes part in the step,
/// when there is no listener.
bool World::NeedsAttention(b2Contact& contact)
{
    ContactData& c = Data(contact);
    const bool touching = (c.flags & kContactMeets) != 0;
    if ((c.flags & kContactApart) != 0 || touching != c.IsTouching() || listener != nullptr ||
        (touching && !c.IsSensor() && WakesNeighbours(Data(*c.bodyA), Data(*c.bodyB))))
    {
        return true;
    }
    c.flags |= kContactEnabled;
    c.flags &= ~std::uint32_t(kContactComputed);
    graph.NoteForm(c);
    return false;
}

// In both loops the list changes: a removed contact is replaced by the last one, woken ones are
// appended and updated as well.

void World::FinishContacts()
{
    b2Manifold old;
    for (std::size_t i = 0; i < awakeContacts.size();)
    {
        ReadAhead(awakeContacts, i);
        b2Contact* contact = awakeContacts[i];
        ContactData& c = Data(*contact);
        const bool computed = (c.flags & kContactComputed) != 0;
        if (!computed)
        {
            ComputeContact(*contact, old);
        }
        if ((c.flags & kContactApart) != 0)
        {
            DestroyContact(*contact);
            continue;
        }
        const bool kept = computed && !oldManifolds.empty();
        FinishContact(*contact, kept ? oldManifolds[std::size_t(c.oldIndex)] : old);
        ++i;
    }
}

void World::FinishContactsInNeed()
{
    b2Manifold old;
    for (std::size_t i = 0; i < awakeContacts.size();)
    {
        if (i < attention.size() && attention[i] == 0)
        {
            ++i;
            continue;
        }
        b2Contact* contact = awakeContacts[i];
        ContactData& c = Data(*contact);
        if ((c.flags & kContactComputed) == 0)
        {
            ComputeContact(*contact, old);
        }
        if ((c.flags & kContactApart) == 0)
        {
            FinishContact(*contact, old);
            ++i;
            continue;
        }
        DestroyContact(*contact);
        const std::size_t last = awakeContacts.size(); // origin of the one at i
        if (i < attention.size())
        {
            attention[i] = last < attention.size() ? attention[last] : 1;
            attention.resize(b2Min(attention.size(), last));
        }
    }
}

/// Reverts the first phase of an update when a callback made the second impossible.
void World::ForgetUpdate(ContactData& c)
{
    if ((c.flags & kContactComputed) != 0)
    {
        c.flags &= ~std::uint32_t(kContactComputed | kContactApart | kContactKept);
        c.manifold = oldManifolds[std::size_t(c.oldIndex)]; // only a listener can cause this
    }
}

void World::UpdateContact(b2Contact& contact)
{
    ContactData& c = Data(contact);
    const b2Transform bInA = RelativeTransform(Data(*c.bodyA), Data(*c.bodyB));
    const b2Manifold old = c.manifold;
    if (!IsKept(c, bInA))
    {
        ComputeManifold(c, bInA, old);
    }
    FinishContact(contact, old);
}

void World::ComputeContact(b2Contact& contact, b2Manifold& old)
{
    ContactData& c = Data(contact);
    c.flags = (c.flags | kContactComputed) & ~std::uint32_t(kContactApart);
    const b2Transform bInA = RelativeTransform(Data(*c.bodyA), Data(*c.bodyB));
    old = c.manifold;
    // Touching contacts that hardly moved still touch: fixtures and boxes are not read.
    if (IsKept(c, bInA))
    {
        return;
    }
    if (!b2TestOverlap(ProxyA(c).aabb, ProxyB(c).aabb))
    {
        c.flags |= kContactApart;
        return;
    }
    ComputeManifold(c, bInA, old);
}

void World::ComputeManifold(ContactData& c, const b2Transform& bInA, const b2Manifold& old)
{
    const b2Shape& shapeA = *c.fixtureA->GetShape();
    const b2Shape& shapeB = *c.fixtureB->GetShape();
    c.radiusA = shapeA.m_radius;
    c.radiusB = shapeB.m_radius;
    c.relative = bInA;
    bool touching = false;
    if (c.IsSensor())
    {
        touching = b2TestOverlap(&shapeA, c.childA, &shapeB, c.childB, b2Transform(), bInA);
        c.manifold.pointCount = 0;
    }
    else
    {
        Collide(&c.manifold, shapeA, c.childA, shapeB, c.childB, bInA);
        CarryImpulses(c.manifold, old);
        touching = c.manifold.pointCount > 0;
    }
    // A circle's manifold is cheap to compute.
    const bool kept = touching && !c.IsSensor() && shapeB.GetType() == b2Shape::e_polygon;
    c.flags &= ~std::uint32_t(kContactMeets | kContactKept);
    c.flags |= (touching ? kContactMeets : 0u) | (kept ? kContactKept : 0u);
}

void World::FinishContact(b2Contact& contact, const b2Manifold& old)
{
    ContactData& c = Data(contact);
    const bool touching = (c.flags & kContactMeets) != 0;
    c.flags |= kContactEnabled;
    c.flags &= ~std::uint32_t(kContactComputed);
    graph.NoteForm(c);
    if (touching != c.IsTouching())
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
            const b2Manifold before = c.manifold;
            listener->PreSolve(&contact, &old);
            if (!IsSame(before, c.manifold))
            {
                c.flags &= ~std::uint32_t(kContactKept); // its change lasts for one step
            }
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
