// SPDX-License-Identifier: MIT
#include <debugdraw/Arrow.h>
#include <debugdraw/WorldContacts.h>

#include <algorithm>
#include <functional>

namespace boxreel
{

namespace
{

constexpr float kOldPoint = 5.0f;      // diameter [px]
constexpr float kNewPoint = 8.0f;      // [px]
constexpr double kNormalLength = 12.0; // [px]
constexpr ArrowHead kPushHead{7.0, 2.5};
// Distinguishes friction from impulses in any colour.
constexpr ArrowHead kFrictionHead{7.0, 3.5, true};
constexpr double kShortest = 1.5;  // shorter arrows are not legible [px]
constexpr double kHeadReach = 8.0; // upper bound of the head's extent beside the shaft [px]

/// A contact point that may be seen, and what goes through it.
struct Spot
{
    b2Vec2 point;            // [m]
    b2Vec2 normal;           // from the first fixture to the second
    float32 push = 0.0f;     // along the normal [N s]
    float32 friction = 0.0f; // along the tangent [N s]
    bool isOld = false;
};

/// Returns the box of the points themselves: an impact that rotated a long body since moves them
/// out of both fixtures' boxes.
Rect BoxAround(const b2WorldManifold& manifold, int32 pointCount)
{
    b2Vec2 lower = manifold.points[0];
    b2Vec2 upper = lower;
    for (int32 i = 1; i < pointCount; ++i)
    {
        lower = b2Min(lower, manifold.points[i]);
        upper = b2Max(upper, manifold.points[i]);
    }
    return {{lower.x, lower.y}, {upper.x, upper.y}};
}

/// Returns the length of the longest impulse arrow [px], by which every spot is enlarged.
double LongestArrow(const b2Manifold& manifold, double metersPerImpulse, double pixelsPerMeter)
{
    double longest = 0.0;
    for (int32 i = 0; i < manifold.pointCount; ++i)
    {
        const b2ManifoldPoint& p = manifold.points[i];
        longest =
            std::max({longest, double(b2Abs(p.normalImpulse)), double(b2Abs(p.tangentImpulse))});
    }
    return longest * metersPerImpulse * pixelsPerMeter;
}

void AddArrows(const std::vector<Spot>& spots, const View& view, double metersPerImpulse,
               bool alongNormal, DrawList& list)
{
    for (const Spot& spot : spots)
    {
        const b2Vec2 direction = alongNormal ? spot.normal : b2Cross(spot.normal, 1.0f);
        const float32 length =
            float32(double(alongNormal ? spot.push : spot.friction) * metersPerImpulse);
        const b2Vec2 tip = spot.point + length * direction;
        if (b2Abs(length) * view.camera.pixelsPerMeter * view.zoom >= kShortest)
        {
            AddArrow(list, view.camera, {spot.point.x, spot.point.y}, {tip.x, tip.y},
                     alongNormal ? ColorRole::ContactImpulse : ColorRole::ContactFriction,
                     alongNormal ? kPushHead : kFrictionHead);
        }
    }
}

void AddNormals(const std::vector<Spot>& spots, const View& view, DrawList& list)
{
    const float32 length = float32(kNormalLength / view.camera.pixelsPerMeter);
    for (const Spot& spot : spots)
    {
        const b2Vec2 tip = spot.point + length * spot.normal;
        list.AddSegment({spot.point.x, spot.point.y}, {tip.x, tip.y}, ColorRole::ContactNormal);
    }
}

void AddPoints(const std::vector<Spot>& spots, DrawList& list)
{
    for (const Spot& spot : spots)
    {
        list.AddPoint({spot.point.x, spot.point.y}, spot.isOld ? kOldPoint : kNewPoint,
                      spot.isOld ? ColorRole::OldContact : ColorRole::NewContact);
    }
}

} // namespace

bool ContactCollector::Memory::IsOf(const Memory& other) const
{
    return contact == other.contact && fixtureA == other.fixtureA && fixtureB == other.fixtureB &&
           bodyA == other.bodyA && bodyB == other.bodyB && childA == other.childA &&
           childB == other.childB;
}

ContactCollector::Memory ContactCollector::MemoryOf(const b2Contact& contact)
{
    const b2Fixture* const a = contact.GetFixtureA();
    const b2Fixture* const b = contact.GetFixtureB();
    return {&contact,
            a,
            b,
            a->GetBody()->GetNumber(),
            b->GetBody()->GetNumber(),
            contact.GetChildIndexA(),
            contact.GetChildIndexB(),
            *contact.GetManifold()};
}

void ContactCollector::Remember(const b2World& world)
{
    m_before.clear();
    for (const b2Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext())
    {
        if (c->IsTouching())
        {
            m_before.push_back(MemoryOf(*c));
        }
    }
    std::sort(m_before.begin(), m_before.end(), [](const Memory& a, const Memory& b) {
        return std::less<const b2Contact*>()(a.contact, b.contact);
    });
}

const b2Manifold* ContactCollector::ManifoldBefore(const b2Contact& contact) const
{
    const auto found = std::lower_bound(m_before.begin(), m_before.end(), &contact,
                                        [](const Memory& a, const b2Contact* b) {
                                            return std::less<const b2Contact*>()(a.contact, b);
                                        });
    return found != m_before.end() && found->IsOf(MemoryOf(contact)) ? &found->manifold : nullptr;
}

void ContactCollector::Collect(const b2World& world, const View& view, const ContactLook& look,
                               DrawList& list) const
{
    const double metersPerImpulse = look.metersPerNewton * look.stepsPerSecond;
    std::vector<Spot> spots;
    for (const b2Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext())
    {
        const b2Manifold& manifold = *c->GetManifold();
        const bool hasArrows = look.impulses || look.friction;
        const double arrow =
            hasArrows ? LongestArrow(manifold, metersPerImpulse, view.camera.pixelsPerMeter) : 0.0;
        const double reach = std::max(arrow, kNormalLength) + kHeadReach;
        if (!c->IsTouching())
        {
            continue;
        }
        b2WorldManifold there;
        c->GetWorldManifold(&there);
        if (!view.Shows(BoxAround(there, manifold.pointCount), reach))
        {
            continue;
        }
        b2PointState unused[b2_maxManifoldPoints];
        b2PointState states[b2_maxManifoldPoints] = {b2_addState, b2_addState};
        if (const b2Manifold* const before = ManifoldBefore(*c))
        {
            b2GetPointStates(unused, states, before, &manifold);
        }
        for (int32 i = 0; i < manifold.pointCount; ++i)
        {
            const b2ManifoldPoint& p = manifold.points[i];
            spots.push_back({there.points[i], there.normal, p.normalImpulse, p.tangentImpulse,
                             states[i] == b2_persistState});
        }
    }
    list.owner = kNoOwner;
    if (look.normals)
    {
        list.layer = DrawLayer::ContactNormals;
        AddNormals(spots, view, list);
    }
    if (look.impulses)
    {
        list.layer = DrawLayer::ContactImpulses;
        AddArrows(spots, view, metersPerImpulse, true, list);
    }
    if (look.friction)
    {
        list.layer = DrawLayer::ContactFriction;
        AddArrows(spots, view, metersPerImpulse, false, list);
    }
    if (look.points)
    {
        list.layer = DrawLayer::Contacts;
        AddPoints(spots, list);
    }
}

} // namespace boxreel
