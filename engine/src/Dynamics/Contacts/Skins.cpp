// SPDX-License-Identifier: MIT
#include "Skins.h"

#include "../State/Access.h"
#include "../State/World.h"
#include "Narrowphase.h"

#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

namespace box2d
{

namespace
{

/// Where skins were put into each other by more than this [m], they become thinner. Bodies at rest
/// overlap by about a slop, and impacts leave up to this (docs/notes/contact-constants.md). With 1
/// slop all tests pass; with 3 a ball that is put on the ground ends 5.3 mm too high.
constexpr float32 kPlacedOverlap = 1.5f * b2_linearSlop;

/// Returns the skin of a shape [m]. The rest of a radius is part of the shape.
float32 SkinOf(const b2Shape& shape)
{
    return shape.GetType() == b2Shape::e_circle ? 0.0f : b2Min(shape.m_radius, b2_polygonRadius);
}

/// Returns the manifold in body A's frame.
b2WorldManifold ManifoldInA(const ContactData& c, const b2Transform& bInA)
{
    b2WorldManifold manifold;
    manifold.Initialize(&c.manifold, b2Transform(), c.radiusA, bInA, c.radiusB);
    return manifold;
}

/// True if the program has put one of the bodies here since the last step. Only with sub-steps: 1
/// is the scheme of Box2D.
bool IsPlaced(const World& world, const ContactData& c)
{
    return world.settings.subStepCount > 1 && (Data(*c.bodyA).placedAt == world.stepNumber ||
                                               Data(*c.bodyB).placedAt == world.stepNumber);
}

/// A body that is put on a shape of the ground must be this far within it [m], also after its path
/// in this time [s]. The distance is twice the skins of two polygons; no test fails with 0 or 0.4
/// m. The time is longer than pushing out its skins takes. With 0.05 s a box that is pushed later
/// slides on thin skins (docs/notes/tuned-constants.md).
constexpr float32 kWithin = 4.0f * b2_polygonRadius;
constexpr float32 kWithinFor = 0.5f;

/// Returns how far below a point of a contact a ground is tested [m]. The point is between the
/// surfaces of the skins, so it is above the shape itself by the ground's radius at most.
float32 DepthOfTest(const b2Shape& ground)
{
    return b2_linearSlop + (ground.GetType() == b2Shape::e_circle ? 0.0f : ground.m_radius);
}

/// Returns the velocity of body B relative to A at a point, in body A's frame.
b2Vec2 RelativeVelocity(const BodyData& a, const BodyData& b, const b2Transform& bInA,
                        const b2Vec2& point)
{
    return b2MulT(a.rotation, b.linearVelocity - a.linearVelocity) +
           b2Cross(b.angularVelocity, point - b2Mul(bInA, b.localCenter)) -
           b2Cross(a.angularVelocity, point - a.localCenter);
}

/// True if neither body is a ground, or if the other one will stay well within this shape of it. On
/// the outline of a ground a body would catch on the next shape. Edges have no inside.
bool StaysWithinGround(const ContactData& c, const b2WorldManifold& manifold,
                       const b2Transform& bInA)
{
    const BodyData& a = Data(*c.bodyA);
    const BodyData& b = Data(*c.bodyB);
    const b2Shape& shapeA = *c.FixtureA()->GetShape();
    if (IsThin(shapeA.GetType())) // of a pair with an edge it is shape A
    {
        return false;
    }
    if (a.IsDynamic() && b.IsDynamic())
    {
        return true;
    }
    const bool isGroundA = !a.IsDynamic();
    const b2Shape& ground = isGroundA ? shapeA : *c.FixtureB()->GetShape();
    const b2Transform frame = isGroundA ? b2Transform() : bInA;
    const b2Vec2 down = DepthOfTest(ground) * (isGroundA ? -manifold.normal : manifold.normal);
    const b2Vec2 tangent = b2Cross(1.0f, manifold.normal);
    bool isWithin = true;
    for (int32 i = 0; i < c.manifold.pointCount; ++i)
    {
        const b2Vec2 velocity = RelativeVelocity(a, b, bInA, manifold.points[i]);
        const float32 path = kWithinFor * b2Abs(b2Dot(velocity, tangent));
        const b2Vec2 along = (kWithin + path) * tangent;
        const b2Vec2 point = manifold.points[i] + down;
        isWithin &=
            ground.TestPoint(frame, point + along) && ground.TestPoint(frame, point - along);
    }
    return isWithin;
}

/// Returns the share of the skins that keeps apart shapes that were put somewhere and touch.
float32 PlacedSkins(const ContactData& c, float32 skins, const b2Transform& bInA)
{
    const b2WorldManifold manifold = ManifoldInA(c, bInA);
    if (!StaysWithinGround(c, manifold, bInA))
    {
        return 1.0f;
    }
    float32 overlap = 0.0f;
    for (int32 i = 0; i < c.manifold.pointCount; ++i)
    {
        overlap = b2Max(overlap, -manifold.separations[i]);
    }
    const float32 thinner = overlap > kPlacedOverlap ? overlap - kRestOverlap : 0.0f;
    return thinner < skins ? 1.0f - thinner / skins : 0.0f;
}

} // namespace

void UpdateSkins(const World& world, ContactData& c, const b2Transform& bInA, bool isFirst)
{
    const b2Shape& shapeA = *c.FixtureA()->GetShape();
    const b2Shape& shapeB = *c.FixtureB()->GetShape();
    const float32 skinA = SkinOf(shapeA);
    const float32 skinB = SkinOf(shapeB);
    const bool touching = c.manifold.pointCount > 0;
    const bool placed = isFirst && IsPlaced(world, c);
    if (!touching || !c.IsTouching() || placed)
    {
        c.skins = touching && placed ? PlacedSkins(c, skinA + skinB, bInA) : 1.0f;
    }
    else if (c.skins < 1.0f && !StaysWithinGround(c, ManifoldInA(c, bInA), bInA))
    {
        c.skins = 1.0f;
    }
    c.radiusA = shapeA.m_radius - (1.0f - c.skins) * skinA;
    c.radiusB = shapeB.m_radius - (1.0f - c.skins) * skinB;
}

} // namespace box2d
