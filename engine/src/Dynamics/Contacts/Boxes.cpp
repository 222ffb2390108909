// SPDX-License-Identifier: MIT
#include "Boxes.h"

#include "../State/BodyPose.h"
#include "../State/Proxies.h"
#include "../State/World.h"
#include "Sweeps.h"

#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

namespace box2d
{

namespace
{

/// The largest margin of a box, as a share of the half size of its shape. It applies to half sizes
/// below 0.4 m, because the manual's margin would touch all of their neighbours'. Larger finds more
/// pairs that do not touch; smaller changes the tree more often. With half of it, rain
/// takes 1.09 of the time and ragdolls 1.05 (docs/notes/collision-speed.md).
constexpr float32 kMarginShare = 0.25f;

/// Returns the distance that a box may move before the tree has to change [m]. Large shapes have
/// the manual's margin.
float32 Margin(const b2AABB& box)
{
    const b2Vec2 half = box.GetExtents();
    return b2Min(b2_aabbExtension, kMarginShare * b2Max(half.x, half.y));
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

/// The box of a bullet's path. Hits after the present step do not matter.
b2AABB Widen(const b2AABB& box, float32 minExtent)
{
    const float32 margin = b2Min(b2_aabbExtension, kMarginShare * minExtent);
    b2AABB wide;
    wide.lowerBound = box.lowerBound - b2Vec2(margin, margin);
    wide.upperBound = box.upperBound + b2Vec2(margin, margin);
    return wide;
}

/// True if the only shape is a circle about the centre of mass, which is the same at any angle.
bool IsRound(const BodyData& body)
{
    const b2Fixture* f = body.fixtureList;
    return f != nullptr && f->GetNext() == nullptr && f->GetType() == b2Shape::e_circle &&
           static_cast<const b2CircleShape*>(f->GetShape())->m_p == b2Vec2(0.0f, 0.0f) &&
           body.localCenter == b2Vec2(0.0f, 0.0f);
}

/// The body's transform at the start of its path, as far as its boxes need it.
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

/// The box of a shape now and, if there is one, at an earlier transform. A corner that turns far
/// comes out of both.
b2AABB BoxOnPath(const b2Shape& shape, int32 child, const BodyData& body, const b2Transform* before)
{
    if (before != nullptr && !IsRound(body) && IsWide(body.pose.angle - body.previous.angle))
    {
        return BoxOfPath(b2Mul(*before, body.localCenter), body.worldCenter, body.maxExtent);
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

/// Returns the distance the inner box may move in any direction without leaving the outer one [m].
float32 RoomIn(const b2AABB& outer, const b2AABB& inner)
{
    const b2Vec2 below = inner.lowerBound - outer.lowerBound;
    const b2Vec2 above = outer.upperBound - inner.upperBound;
    const b2Vec2 minimum = b2Min(below, above);
    return b2Min(minimum.x, minimum.y);
}

/// Returns the maximum difference of boxes in single precision from those of the exact pose, now
/// and later [m]. A bound takes eight roundings by half an epsilon: sine, cosine, origin, two
/// products, two sums, skin. Both boxes have eight epsilons together. This is twice that.
float32 BoxRounding(const BodyData& body)
{
    constexpr float32 epsilons = 16.0f;
    const float32 farthest = b2Abs(body.worldCenter.x) + b2Abs(body.worldCenter.y) + body.maxExtent;
    return epsilons * b2_epsilon * farthest;
}

/// Call after an impact. The boxes then also contain the rest of the path.
void GrowBoxes(Proxies& proxies, BodyData& body)
{
    body.flags |= kBodyBoxMoved;
    const b2Transform before = TransformBefore(body);
    ForProxies(body, [&](b2FixtureProxy& proxy) {
        const b2AABB box = BoxOnPath(*proxy.fixture->GetShape(), proxy.childIndex, body, &before);
        proxy.aabb.Combine(Widen(box, body.minExtent));
        proxies.Grow(proxy.proxyId, proxy.aabb);
    });
}

} // namespace

void CreateProxies(Proxies& proxies, b2Fixture& fixture)
{
    BodyData& body = Data(*fixture.GetBody());
    body.room = 0.0f;
    body.flags |= kBodyBoxMoved;
    body.placedAt = body.world->stepNumber;
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

void DestroyProxies(Proxies& proxies, b2Fixture& fixture)
{
    for (int32 child = 0; child < FixtureAccess::ProxyCount(fixture); ++child)
    {
        b2FixtureProxy& proxy = FixtureAccess::Proxies(fixture)[child];
        proxies.Destroy(proxy.proxyId);
        proxy.proxyId = -1;
    }
    FixtureAccess::ProxyCount(fixture) = 0;
}

void UpdateProxies(Proxies& proxies, BodyData& body, bool swept)
{
    if (swept && (body.flags & kBodyPathBox) != 0)
    {
        GrowBoxes(proxies, body);
    }
    else if (RefreshBoxes(body, swept))
    {
        MoveProxies(proxies, body);
    }
}

bool RefreshBoxes(BodyData& body, bool swept)
{
    const bool bullet = swept && (body.flags & kBodyBullet) != 0;
    // The boxes of a bullet's path serve for one step.
    const bool rebuilds = bullet || (body.flags & kBodyPathBox) != 0;
    bool left = rebuilds;
    b2Transform before;
    float32 room = b2_maxFloat;
    const b2Vec2 displacement(float32(body.pose.x - body.previous.x),
                              float32(body.pose.y - body.previous.y));
    if (swept)
    {
        before = TransformBefore(body);
    }
    for (b2Fixture* f = body.fixtureList; f; f = f->GetNext())
    {
        for (int32 child = 0; child < FixtureAccess::ProxyCount(*f); ++child)
        {
            b2FixtureProxy& proxy = FixtureAccess::Proxies(*f)[child];
            const b2AABB box = BoxOnPath(*f->GetShape(), child, body, swept ? &before : nullptr);
            if (rebuilds || !proxy.aabb.Contains(box))
            {
                proxy.aabb = bullet ? Widen(box, body.minExtent) : Fatten(box, displacement);
                left = true;
            }
            room = b2Min(room, RoomIn(proxy.aabb, box));
        }
    }
    body.flags = bullet ? body.flags | kBodyPathBox : body.flags & ~std::uint32_t(kBodyPathBox);
    body.flags |= left ? std::uint32_t(kBodyBoxMoved) : 0u;
    body.room = bullet ? 0.0f : room - BoxRounding(body);
    return left;
}

void MoveProxies(Proxies& proxies, BodyData& body)
{
    ForProxies(body, [&](const b2FixtureProxy& proxy) {
        const b2AABB& known = proxies.FatBox(proxy.proxyId);
        if (known.lowerBound != proxy.aabb.lowerBound || known.upperBound != proxy.aabb.upperBound)
        {
            proxies.Move(proxy.proxyId, proxy.aabb);
        }
    });
}

void ResetProxies(Proxies& proxies, BodyData& body)
{
    body.flags &= ~std::uint32_t(kBodyPathBox);
    body.flags |= kBodyBoxMoved;
    body.placedAt = body.world->stepNumber;
    ForProxies(body, [&](b2FixtureProxy& proxy) {
        b2AABB box;
        proxy.fixture->GetShape()->ComputeAABB(&box, body.transform, proxy.childIndex);
        proxy.aabb = Fatten(box, b2Vec2(0.0f, 0.0f));
        proxies.Move(proxy.proxyId, proxy.aabb);
    });
}

} // namespace box2d
