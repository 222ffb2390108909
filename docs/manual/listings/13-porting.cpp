// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <cmath>

namespace
{

// [stiffness]
/// Sets a spring as Box2D 2.4 does: a stiffness [N/m] and a damping [N s/m].
void SetSpring(b2DistanceJointDef& def, float32 stiffness, float32 damping)
{
    const float32 a = def.bodyA->GetMass(), b = def.bodyB->GetMass();
    const float32 mass = a > 0.0f && b > 0.0f ? a * b / (a + b) : a + b;
    const bool isSpring = stiffness > 0.0f && mass > 0.0f; // else a rod
    const float32 omega = isSpring ? std::sqrt(stiffness / mass) : 0.0f;
    def.frequencyHz = omega / (2.0f * b2_pi);
    def.dampingRatio = isSpring ? damping / (2.0f * mass * omega) : 0.0f;
}
// [/stiffness]

TEST(PortingListing, SetsASpringByItsStiffness)
{
    manual::Stage stage;
    b2Body* hook = stage.Body(b2_staticBody, 0.0f, 10.0f);
    b2Body* load = stage.Box(0.0f, 7.0f, 1.0f, 1.0f); // 4 kg
    b2DistanceJointDef def;
    def.Initialize(hook, load, hook->GetPosition(), load->GetPosition());
    SetSpring(def, 100.0f, 20.0f);
    stage.world.CreateJoint(&def);
    stage.Run(10.0f);
    EXPECT_NEAR(7.0f - load->GetPosition().y, 4.0f * 10.0f / 100.0f, 0.005f) << "m g / k";
    b2Body* held = stage.Box(20.0f, 7.0f);
    def.Initialize(hook, held, b2Vec2(20.0f, 10.0f), held->GetPosition());
    SetSpring(def, 0.0f, 0.0f);
    ASSERT_NE(stage.world.CreateJoint(&def), nullptr);
    EXPECT_EQ(def.frequencyHz, 0.0f) << "a rod";
}

// [one-sided]
/// Chains, and edges with both neighbours, stop only what comes from the right of their direction,
/// as those of Box2D 2.4 do.
class OneSided : public b2ContactListener
{
    /// From one vertex to the next; 0 of what has no direction: another shape, an edge alone.
    static b2Vec2 Direction(b2Fixture& fixture, int32 child)
    {
        b2EdgeShape edge;
        if (fixture.GetType() == b2Shape::e_chain)
        {
            static_cast<b2ChainShape*>(fixture.GetShape())->GetChildEdge(&edge, child);
        }
        else if (fixture.GetType() == b2Shape::e_edge)
        {
            edge = *static_cast<b2EdgeShape*>(fixture.GetShape());
        }
        const bool isSided =
            fixture.GetType() == b2Shape::e_chain || (edge.m_hasVertex0 && edge.m_hasVertex3);
        return isSided ? fixture.GetBody()->GetWorldVector(edge.m_vertex2 - edge.m_vertex1)
                       : b2Vec2_zero;
    }

    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        const b2Vec2 alongA = Direction(*contact->GetFixtureA(), contact->GetChildIndexA());
        const b2Vec2 alongB = Direction(*contact->GetFixtureB(), contact->GetChildIndexB());
        const bool isA = alongA != b2Vec2_zero; // never both: a chain meets no chain
        const b2Vec2 along = isA ? alongA : alongB;
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        const b2Vec2 away = isA ? manifold.normal : -manifold.normal;
        if (b2Cross(along, away) > 0.0f) // to the left
        {
            contact->SetEnabled(false);
        }
    }
};
// [/one-sided]

/// Where a ball is after two seconds that flies at a shape from y.
float32 ThrownAt(const b2Shape& shape, float32 y)
{
    OneSided listener;
    manual::Stage stage(b2Vec2_zero);
    stage.world.SetContactListener(&listener);
    stage.Body(b2_staticBody, 0.0f, 0.0f)->CreateFixture(&shape, 0.0f);
    b2Body* ball = stage.Ball(2.0f, y, 0.3f);
    ball->SetLinearVelocity(b2Vec2(0.0f, y < 0.0f ? 3.0f : -3.0f));
    stage.Run(2.0f);
    stage.world.SetContactListener(nullptr);
    return ball->GetPosition().y;
}

TEST(PortingListing, StopsOnOneSideOnly)
{
    const b2Vec2 fromRightToLeft[] = {{5.0f, 0.0f}, {0.0f, 0.0f}, {-5.0f, 0.0f}};
    b2ChainShape chain;
    chain.CreateChain(fromRightToLeft, 3);
    EXPECT_GT(ThrownAt(chain, 2.0f), 0.25f) << "from the right of a chain to the left: from above";
    EXPECT_GT(ThrownAt(chain, -2.0f), 2.0f);
    b2EdgeShape edge;
    edge.Set(b2Vec2(5.0f, 0.0f), b2Vec2(-5.0f, 0.0f));
    EXPECT_LT(ThrownAt(edge, -2.0f), -0.25f) << "an edge alone stops both sides";
    edge.m_vertex0.Set(6.0f, 0.0f);
    edge.m_vertex3.Set(-6.0f, 0.0f);
    edge.m_hasVertex0 = edge.m_hasVertex3 = true;
    EXPECT_GT(ThrownAt(edge, 2.0f), 0.25f);
    EXPECT_GT(ThrownAt(edge, -2.0f), 2.0f);
}

// [threshold]
/// Impacts slower than this do not bounce; for limits above the engine's own 1 m/s.
class BounceThreshold : public b2ContactListener
{
public:
    float32 slowest = 3.0f; // [m/s]

private:
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        const b2Body* a = contact->GetFixtureA()->GetBody();
        const b2Body* b = contact->GetFixtureB()->GetBody();
        const b2Vec2 point = manifold.points[0];
        const float32 approach = b2Dot(a->GetLinearVelocityFromWorldPoint(point) -
                                           b->GetLinearVelocityFromWorldPoint(point),
                                       manifold.normal);
        contact->ResetRestitution();
        if (approach < slowest)
        {
            contact->SetRestitution(0.0f);
        }
    }
};
// [/threshold]

/// How high a ball of restitution 0.9 comes again that falls from a height.
float32 Rebound(float32 height)
{
    BounceThreshold listener;
    manual::Stage stage;
    stage.world.SetContactListener(&listener);
    stage.Ground();
    b2Body* ball = stage.Ball(0.0f, 0.505f + height);
    ball->GetFixtureList()->SetRestitution(0.9f);
    float32 highest = 0.0f;
    bool fell = false;
    for (int i = 0; i < 180; ++i)
    {
        stage.Run(1.0f / 60.0f);
        fell = fell || ball->GetPosition().y < 0.6f;
        highest = fell ? b2Max(highest, ball->GetPosition().y - 0.505f) : highest;
    }
    stage.world.SetContactListener(nullptr);
    return highest;
}

TEST(PortingListing, BouncesAboveItsThreshold)
{
    EXPECT_GT(Rebound(2.0f), 1.0f) << "at 6.3 m/s";
    EXPECT_LT(Rebound(0.3f), 0.1f) << "at 2.4 m/s";
}

TEST(PortingListing, SetsUpAWorldAsBox2DDoes)
{
    // [as-box2d]
    b2World world(b2Vec2(0.0f, -10.0f)); // one step of first order, one thread, sleep: as in Box2D
    world.Step(1.0f / 60.0f, 8, 3);
    // [/as-box2d]
    EXPECT_EQ(world.GetSubStepCount(), 1);
    EXPECT_EQ(world.GetThreadCount(), 1);
    EXPECT_TRUE(world.GetAllowSleeping());
}

} // namespace
