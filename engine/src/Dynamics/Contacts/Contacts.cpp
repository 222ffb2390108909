// SPDX-License-Identifier: MIT
#include "Contacts.h"

#include "../Islands/Sleep.h"
#include "../State/Access.h"
#include "../State/BodyEdges.h"
#include "../State/BodyPose.h"
#include "../State/World.h"
#include "Narrowphase.h"
#include "ReadAhead.h"
#include "Skins.h"
#include "Sweeps.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <new>

namespace box2d
{

namespace
{

/// Contacts per part of a parallel loop. It affects the time only: with fewer, threads fetch parts
/// too often; with more, the contacts of a small world have fewer parts than threads.
constexpr int32 kContactGrain = 32;

/// True if a joint keeps its two bodies from colliding.
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

/// Copies the impulses of points with the same features, to warm start the solver.
void CopyImpulses(b2Manifold& manifold, const b2Manifold& old)
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

/// A manifold is computed again when a body has moved this far relative to the other since the last
/// computation [m]. Its data is in the bodies' own frames. The points therefore stay in place on
/// their face, and overlap and normal always belong to the present pose. With 0.1 mm, 16 % of the
/// touching contacts of a sagging pyramid are kept, with 1 mm 87 % (docs/notes/solver-lanes.md).
/// With 0.5 mm, 100 pyramids take 0.79 of the time without kept manifolds.
constexpr float32 kStill = 0.1f * b2_linearSlop;
/// The same as a share of the distance of its furthest point from its centre. It is smaller than
/// kStill for distances below 0.1 m, the smallest size that the manual advises. With 0.05 no
/// verdict of the tests changes (docs/notes/tuned-constants.md).
constexpr float32 kStillShare = 0.005f;

bool IsStill(const BodyData& bodyB, const b2Transform& relative, const b2Transform& bInA)
{
    const float32 reach = bodyB.maxExtent;
    const float32 still = b2Min(kStill, kStillShare * reach);
    const b2Vec2 moved = b2Abs(bInA.p - relative.p);
    const float32 turned = b2Max(b2Abs(bInA.q.s - relative.q.s), b2Abs(bInA.q.c - relative.q.c));
    return b2Max(moved.x, moved.y) + turned * reach <= still;
}

bool IsKept(const ContactData& c, const b2Transform& bInA)
{
    return (c.flags & kContactKept) != 0 &&
           c.manifold.pointCount > 0 && // otherwise a listener has emptied it
           IsStill(Data(*c.bodyB), c.relative, bInA);
}

float32 SumOfParts(const b2Vec2& v)
{
    return b2Abs(v.x) + b2Abs(v.y);
}

/// Bound of the rounding of a path, relative to the distances that it is computed from: about 80
/// roundings of a float. Smaller could miss shapes that have met; larger looks at more pairs again.
/// With 0 and 1e-3 all tests pass, also those that compare bits.
constexpr float32 kPathRounding = 0.00001f;

/// True if shapes that were apart still are, because no point has come as far as the gap.
inline bool StayApart(const BodyData& a, const BodyData& b, float32 gap,
                      const b2Transform& relative, const b2Transform& bInA)
{
    const float32 distance = SumOfParts(relative.p);
    const float32 reachA = a.maxExtent + SumOfParts(a.localCenter) + distance;
    const float32 reachB = b.maxExtent + SumOfParts(b.localCenter);
    const float32 reach = gap > 0.0f ? reachB : reachA;
    const float32 turned = // twice the sine of half the angle
        b2Vec2(bInA.q.s - relative.q.s, bInA.q.c - relative.q.c).Length();
    const float32 path = (bInA.p - relative.p).Length() + turned * reach;
    const float32 rounding = kPathRounding * (distance + a.maxExtent + b.maxExtent);
    return path + rounding < b2Abs(gap); // never if there is no gap
}

bool StayApart(const ContactData& c, const b2Transform& bInA)
{
    return c.gap != 0.0f && StayApart(Data(*c.bodyA), Data(*c.bodyB), c.gap, c.relative, bInA);
}

bool BoxMoved(const BodyData& a, const BodyData& b)
{
    return ((a.flags | b.flags) & std::uint32_t(kBodyBoxMoved)) != 0;
}

/// True if the update would change nothing, as of most contacts. Then the contact is not read.
bool IsUnchanged(const PairLook& look, bool hasListener)
{
    const bool apart = look.gap != 0.0f;
    if (!apart && (!look.kept || hasListener))
    {
        return false;
    }
    const BodyData& a = *look.bodyA;
    const BodyData& b = *look.bodyB;
    const b2Transform bInA = RelativeTransform(a, b);
    if (!apart)
    {
        return IsStill(b, look.relative, bInA) && !WakesNeighbours(a, b);
    }
    // Without branches, because which of these decides is unpredictable.
    const int overlap = b2TestOverlap(look.proxyA->aabb, look.proxyB->aabb);
    const int stayApart = StayApart(a, b, look.gap, look.relative, bInA);
    return ((overlap | int(!BoxMoved(a, b))) & stayApart) != 0;
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

/// False for two chains or edges, and for bullets that pass far from each other.
bool CanMeet(const b2FixtureProxy& a, const b2FixtureProxy& b)
{
    const b2Shape& shapeA = *a.fixture->GetShape();
    const b2Shape& shapeB = *b.fixture->GetShape();
    return CanCollide(shapeA.GetType(), shapeB.GetType()) &&
           PathsMeet(Data(*a.fixture->GetBody()), shapeA, a.childIndex, Data(*b.fixture->GetBody()),
                     shapeB, b.childIndex);
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

    b2Contact& contact = AddContact(world, a, b);
    ContactData& c = Data(contact);
    c.flags = kContactEnabled |
              (a.fixture->IsSensor() || b.fixture->IsSensor() ? kContactSensor : 0u) |
              (Data(*c.bodyA).IsDynamic() && Data(*c.bodyB).IsDynamic() ? 0u : kContactObstacle);
    contact.ResetFriction();
    contact.ResetRestitution();
    return &contact;
}

bool ShouldCollide(b2ContactFilter& filter, b2Fixture& fixtureA, b2Fixture& fixtureB)
{
    b2Body& a = *fixtureA.GetBody();
    b2Body& b = *fixtureB.GetBody();
    return &a != &b && (Data(a).IsDynamic() || Data(b).IsDynamic()) && !JointForbids(a, b) &&
           filter.ShouldCollide(&fixtureA, &fixtureB);
}

} // namespace

b2Contact& AddContact(World& world, const b2FixtureProxy& a, const b2FixtureProxy& b)
{
    b2Contact* contact = new (world.allocator.Allocate(int32(sizeof(b2Contact)))) b2Contact();
    ContactData& c = Data(*contact);
    c.proxyA = &a;
    c.proxyB = &b;
    c.bodyA = a.fixture->GetBody();
    c.bodyB = b.fixture->GetBody();
    c.edgeA.contact = c.edgeB.contact = contact;
    c.edgeA.other = c.bodyB;
    c.edgeB.other = c.bodyA;
    PushEdge(Data(*c.bodyA).contactList, c.edgeA);
    PushEdge(Data(*c.bodyB).contactList, c.edgeB);
    c.next = world.contactList;
    if (world.contactList)
    {
        Data(*world.contactList).prev = contact;
    }
    world.contactList = contact;
    ++world.contactCount;
    world.pairs.Insert(a.proxyId, b.proxyId);
    return *contact;
}

void FindNewContacts(World& world)
{
    // Most pairs have a contact: only the others are worth reading their bodies and shapes.
    const auto isKnown = [&world](int32 a, int32 b) {
        return world.pairs.Contains(a, b) || !CanMeet(*world.proxies.Get(a), *world.proxies.Get(b));
    };
    // Pairs that the default filter would always refuse are not searched for.
    const bool filtersByCategory = world.filter == &world.defaultFilter;
    const auto isWanted = [&world, filtersByCategory](const b2FixtureProxy* moved,
                                                      Mobility mobility) {
        const b2Filter& own = moved->fixture->GetFilterData();
        return !filtersByCategory || own.groupIndex != 0 ||
               world.proxies.MayMeet(own.maskBits, mobility);
    };
    world.proxies.FindPairs(
        world.threads.get(), isWanted, isKnown, [&world](b2FixtureProxy* a, b2FixtureProxy* b) {
            if (!ShouldCollide(*world.filter, *a->fixture, *b->fixture))
            {
                return; // the program's filter must be called on its thread
            }
            b2Contact* contact = MakeContact(world, *a, *b);
            UpdateActivity(world, *contact);
            // Otherwise a body that the user moved into a sleeping one would never be looked at.
            if (Data(*contact).awakeIndex == -1)
            {
                Wake(world,
                     *(Data(*a->fixture->GetBody()).IsDynamic() ? a : b)->fixture->GetBody());
            }
        });
}

namespace
{

/// `isFirst`: the bodies have not moved in this step.
void ComputeManifold(World& world, ContactData& c, const b2Transform& bInA, bool isFirst)
{
    const b2Manifold old = c.manifold;
    const b2Shape& shapeA = *c.FixtureA()->GetShape();
    const b2Shape& shapeB = *c.FixtureB()->GetShape();
    c.radiusA = shapeA.m_radius;
    c.radiusB = shapeB.m_radius;
    c.relative = bInA;
    c.gap = 0.0f;
    bool touching = false;
    if (c.IsSensor())
    {
        touching = b2TestOverlap(&shapeA, c.ChildA(), &shapeB, c.ChildB(), b2Transform(), bInA);
        c.manifold.pointCount = 0;
        c.skins = 1.0f;
    }
    else
    {
        c.gap = Collide(&c.manifold, shapeA, c.ChildA(), shapeB, bInA);
        CopyImpulses(c.manifold, old);
        touching = c.manifold.pointCount > 0;
        UpdateSkins(world, c, bInA, isFirst);
    }
    // A circle's manifold is cheap to compute.
    const bool kept = touching && !c.IsSensor() && shapeB.GetType() == b2Shape::e_polygon;
    c.flags &= ~std::uint32_t(kContactMeets | kContactKept);
    c.flags |= (touching ? kContactMeets : 0u) | (kept ? kContactKept : 0u);
    if (c.awakeIndex != -1)
    {
        PairLook& look = world.awakeLooks[std::size_t(c.awakeIndex)];
        look.relative = c.relative;
        look.gap = c.gap;
        look.kept = false;
    }
}

void Keep(const b2Manifold& manifold, b2Manifold* old)
{
    if (old != nullptr)
    {
        *old = manifold;
    }
}

/// Updates the contact without effects on others. `old`, if there is one, receives the previous
/// manifold unless the shapes are apart and stay so; then the result is false.
bool ComputeContact(World& world, b2Contact& contact, b2Manifold* old)
{
    ContactData& c = Data(contact);
    c.flags = (c.flags | kContactComputed) & ~std::uint32_t(kContactApart);
    const b2Transform bInA = RelativeTransform(Data(*c.bodyA), Data(*c.bodyB));
    // A touching contact that has hardly moved still touches, so fixtures and boxes are not read.
    if (IsKept(c, bInA))
    {
        world.awakeLooks[std::size_t(c.awakeIndex)].kept = true; // so it will probably be again
        Keep(c.manifold, old);
        return true;
    }
    // So are those of shapes that are still apart, unless a box has changed.
    const bool stayApart = StayApart(c, bInA);
    if ((BoxMoved(Data(*c.bodyA), Data(*c.bodyB)) || !stayApart) &&
        !b2TestOverlap(c.proxyA->aabb, c.proxyB->aabb))
    {
        c.flags |= kContactApart;
        return false;
    }
    if (!stayApart)
    {
        Keep(c.manifold, old);
        ComputeManifold(world, c, bInA, true);
    }
    return !stayApart;
}

/// Handles the consequences of the new manifold.
void FinishContact(World& world, b2Contact& contact, const b2Manifold& old)
{
    ContactData& c = Data(contact);
    const bool touching = (c.flags & kContactMeets) != 0;
    c.flags |= kContactEnabled;
    c.flags &= ~std::uint32_t(kContactComputed);
    world.graph.NoteForm(c);
    if (touching != c.IsTouching())
    {
        c.flags ^= kContactTouching;
        if (!c.IsSensor())
        {
            Wake(world, *c.bodyA);
            Wake(world, *c.bodyB);
        }
        UpdateActivity(world, contact);
        if (world.listener)
        {
            touching ? world.listener->BeginContact(&contact)
                     : world.listener->EndContact(&contact);
        }
    }
    if (touching && !c.IsSensor())
    {
        WakeNeighbours(world, *c.bodyA, *c.bodyB);
        if (world.listener)
        {
            const b2Manifold before = c.manifold;
            world.listener->PreSolve(&contact, &old);
            if (!IsSame(before, c.manifold))
            {
                ForgetManifold(world, c); // its change lasts for one step
            }
        }
    }
}

/// True if the update needs its second part. Without a listener it is not needed for a contact that
/// only takes part in the step.
bool NeedsAttention(World& world, b2Contact& contact)
{
    ContactData& c = Data(contact);
    const bool touching = (c.flags & kContactMeets) != 0;
    if ((c.flags & kContactApart) != 0 || touching != c.IsTouching() || world.listener != nullptr ||
        (touching && !c.IsSensor() && WakesNeighbours(Data(*c.bodyA), Data(*c.bodyB))))
    {
        return true;
    }
    c.flags |= kContactEnabled;
    c.flags &= ~std::uint32_t(kContactComputed);
    world.graph.NoteForm(c);
    return false;
}

/// Performs the first part of all updates, on all threads. With one thread and no listener that
/// could see the difference, it does nothing and returns false. Each contact is then updated in its
/// turn. The results are the same, because poses and velocities do not change
/// meanwhile.
bool ComputeContacts(World& world)
{
    const bool keepOld = world.listener != nullptr;
    if (!world.threads && !keepOld)
    {
        return false;
    }
    world.oldManifolds.resize(keepOld ? world.awakeContacts.size() : 0);
    world.attention.resize(world.awakeContacts.size());
    ParallelFor(world.threads.get(), int32(world.awakeContacts.size()), kContactGrain,
                [&](int32 begin, int32 end) {
                    for (int32 i = begin; i < end; ++i)
                    {
                        ReadAhead(world, std::size_t(i), std::size_t(end));
                        PairLook& look = world.awakeLooks[std::size_t(i)];
                        look.unchanged = IsUnchanged(look, keepOld);
                        if (look.unchanged)
                        {
                            world.attention[std::size_t(i)] = 0;
                            continue;
                        }
                        b2Contact& contact = *world.awakeContacts[std::size_t(i)];
                        b2Manifold* old = keepOld ? &world.oldManifolds[std::size_t(i)] : nullptr;
                        Data(contact).oldIndex = ComputeContact(world, contact, old) ? i : -1;
                        world.attention[std::size_t(i)] = NeedsAttention(world, contact);
                    }
                });
    return true;
}

// In both of these the list changes during the loop. A removed contact is replaced by the last one.
// Contacts that wake are appended and updated as well.

/// `hasFirstPart`: ComputeContacts has looked at those that were awake then.
void FinishContacts(World& world, bool hasFirstPart)
{
    b2Manifold old;
    for (std::size_t i = 0; i < world.awakeContacts.size();)
    {
        ReadAhead(world, i, world.awakeContacts.size());
        const PairLook& look = world.awakeLooks[i];
        if (hasFirstPart ? look.unchanged : IsUnchanged(look, world.listener != nullptr))
        {
            ++i;
            continue;
        }
        b2Contact* contact = world.awakeContacts[i];
        ContactData& c = Data(*contact);
        const bool computed = (c.flags & kContactComputed) != 0;
        if (!computed)
        {
            ComputeContact(world, *contact, world.listener != nullptr ? &old : nullptr);
        }
        if ((c.flags & kContactApart) != 0)
        {
            DestroyContact(world, *contact);
            continue;
        }
        const bool kept = computed && !world.oldManifolds.empty() && c.oldIndex != -1;
        FinishContact(world, *contact, kept ? world.oldManifolds[std::size_t(c.oldIndex)] : old);
        ++i;
    }
}

void FinishContactsInNeed(World& world)
{
    b2Manifold old;
    for (std::size_t i = 0; i < world.awakeContacts.size();)
    {
        if (i < world.attention.size() && world.attention[i] == 0)
        {
            ++i;
            continue;
        }
        b2Contact* contact = world.awakeContacts[i];
        ContactData& c = Data(*contact);
        if ((c.flags & kContactComputed) == 0)
        {
            ComputeContact(world, *contact, world.listener != nullptr ? &old : nullptr);
        }
        if ((c.flags & kContactApart) == 0)
        {
            FinishContact(world, *contact, old);
            ++i;
            continue;
        }
        DestroyContact(world, *contact);
        const std::size_t last = world.awakeContacts.size(); // where the one at i has come from
        if (i < world.attention.size())
        {
            world.attention[i] = last < world.attention.size() ? world.attention[last] : 1;
            world.attention.resize(b2Min(world.attention.size(), last));
        }
    }
}

} // namespace

void UpdateContacts(World& world)
{
    if (world.filtersChanged)
    {
        world.filtersChanged = false;
        for (b2Contact* contact = world.contactList; contact;)
        {
            b2Contact* next = contact->GetNext();
            ContactData& c = Data(*contact);
            if ((c.flags & kContactFilter) != 0 &&
                !ShouldCollide(*world.filter, *c.FixtureA(), *c.FixtureB()))
            {
                DestroyContact(world, *contact);
            }
            else
            {
                c.flags &= ~std::uint32_t(kContactFilter);
            }
            contact = next;
        }
    }
    // Without a listener most contacts need only the first part.
    const bool hasFirstPart = ComputeContacts(world);
    hasFirstPart&& world.listener == nullptr ? FinishContactsInNeed(world)
                                             : FinishContacts(world, hasFirstPart);
}

void UpdateContact(World& world, b2Contact& contact)
{
    ContactData& c = Data(contact);
    const b2Transform bInA = RelativeTransform(Data(*c.bodyA), Data(*c.bodyB));
    const b2Manifold old = c.manifold;
    if (!IsKept(c, bInA) && !StayApart(c, bInA))
    {
        ComputeManifold(world, c, bInA, false);
    }
    FinishContact(world, contact, old);
}

void DestroyContact(World& world, b2Contact& contact)
{
    ContactData& c = Data(contact);
    if (c.IsTouching())
    {
        if (world.listener)
        {
            const Lock lock(world);
            world.listener->EndContact(&contact);
        }
        c.flags &= ~std::uint32_t(kContactTouching);
        if (!c.IsSensor())
        {
            Wake(world, *c.bodyA);
            Wake(world, *c.bodyB);
        }
        UpdateActivity(world, contact);
    }
    if (c.awakeIndex != -1)
    {
        RemoveFromAwake(world, c);
    }
    world.pairs.Erase(c.proxyA->proxyId, c.proxyB->proxyId);
    RemoveEdge(Data(*c.bodyA).contactList, c.edgeA);
    RemoveEdge(Data(*c.bodyB).contactList, c.edgeB);
    (c.prev ? Data(*c.prev).next : world.contactList) = c.next;
    if (c.next)
    {
        Data(*c.next).prev = c.prev;
    }
    --world.contactCount;
    contact.~b2Contact();
    world.allocator.Free(&contact, int32(sizeof(b2Contact)));
}

} // namespace box2d
