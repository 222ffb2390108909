// SPDX-License-Identifier: MIT
#include "Skins.h"

#include "../State/Access.h"
#include "../State/World.h"

#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

namespace box2d
{

namespace
{

/// Where skins were put into each other by more than this [m], they become thinner. Less is about
/// the overlap that bodies have at rest.
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

/// How far a shape of the ground extends around the points of a body that is put on it [m], and for
/// how long the body stays on it [s]: longer than pushing out its skins takes.
constexpr float32 kWithin = 4.0f * b2_polygonRadius;
constexpr float32 kWithinFor = 0.5f;
/// How far below the points that is tested [m], because they are on the surface.
constexpr float32 kBelow = 0.5f * b2_polygonRadius;

/// True if a contact without a ground, or if the body will stay well within this shape of it. On
/// the outline of the ground the body would catch on the next shape.
bool StaysWithinGround(const ContactData& c, const b2WorldManifold& manifold,
                       const b2Transform& bInA)
{
    const BodyData& a = Data(*c.bodyA);
    const BodyData& b = Data(*c.bodyB);
    if (a.IsDynamic() && b.IsDynamic())
    {
        return true;
    }
    const bool isGroundA = !a.IsDynamic();
    const b2Shape& ground = *(isGroundA ? c.FixtureA() : c.FixtureB())->GetShape();
    const b2Transform frame = isGroundA ? b2Transform() : bInA;
    const b2Vec2 down = (isGroundA ? -kBelow : kBelow) * manifold.normal;
    const b2Vec2 tangent = b2Cross(1.0f, manifold.normal);
    const b2Vec2 speed = b2MulT(a.rotation, b.linearVelocity - a.linearVelocity);
    const b2Vec2 along = (kWithin + kWithinFor * b2Abs(b2Dot(speed, tangent))) * tangent;
    bool isWithin = true;
    for (int32 i = 0; i < c.manifold.pointCount; ++i)
    {
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
