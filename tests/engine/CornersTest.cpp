// SPDX-License-Identifier: MIT
#include "SubStepsScene.h"

#include <gtest/gtest.h>

/// BounceInCorners, as the user sees it. tests/stability/WedgeTest.cpp measures the energy.
namespace
{

using namespace dynamics;

/// Adds up the impulses that are reported.
struct Impulses : b2ContactListener
{
    b2Vec2 sum = b2Vec2_zero;
    int32 calls = 0;

    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override
    {
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        for (int32 i = 0; i < impulse->count; ++i)
        {
            sum += impulse->normalImpulses[i] * manifold.normal;
        }
        ++calls;
    }
};

/// A ball that touches both walls of a wedge of 10 degrees and flies along its axis.
struct Wedge : SmallScene
{
    static constexpr float32 kRadius = 0.3f;
    b2Body* ball;

    Wedge() : SmallScene(b2Vec2_zero, 1)
    {
        const float32 half = 5.0f * b2_pi / 180.0f;
        const b2Vec2 end(60.0f * std::sin(half), 60.0f * std::cos(half));
        for (const float32 side : {-1.0f, 1.0f})
        {
            b2EdgeShape wall;
            wall.Set(b2Vec2_zero, b2Vec2(side * end.x, end.y));
            Add(Body(b2_staticBody, 0.0f, 0.0f), wall, 0.0f, 1.0f);
        }
        ball = Body(b2_dynamicBody, 0.0f, kRadius / std::sin(half));
        AddBall(ball, kRadius, 0.0f, 1.0f);
        Step(); // the contacts begin
        ball->SetLinearVelocity(b2Vec2(0.0f, -20.0f));
    }
};

TEST(Corners, ReverseTheVelocityOfABallInOneStep)
{
    Wedge wedge;
    wedge.Step();
    EXPECT_NEAR(wedge.ball->GetLinearVelocity().x, 0.0f, 0.01f);
    EXPECT_NEAR(wedge.ball->GetLinearVelocity().y, 20.0f, 0.01f);
}

TEST(Corners, ReportTheImpulsesOfABounceToTheListener)
{
    Wedge wedge;
    Impulses impulses;
    wedge.world.SetContactListener(&impulses);
    wedge.Step();
    wedge.world.SetContactListener(nullptr);
    const float32 change = 40.0f * wedge.ball->GetMass();
    EXPECT_EQ(impulses.calls, 2);
    EXPECT_NEAR(impulses.sum.x, 0.0f, 0.01f * change);
    EXPECT_NEAR(impulses.sum.y, change, 0.01f * change);
}

TEST(Corners, LeaveNoImpulseOfABounceToTheNextStep)
{
    Wedge wedge;
    wedge.Step();
    for (const b2Contact* c = wedge.world.GetContactList(); c; c = c->GetNext())
    {
        EXPECT_EQ(c->GetManifold()->points[0].normalImpulse, 0.0f);
    }
}

/// The ball already leaves both walls, which pushed it in the step before.
TEST(Corners, ForgetAnImpulseOfTheLastStep)
{
    Wedge wedge;
    for (b2Contact* c = wedge.world.GetContactList(); c; c = c->GetNext())
    {
        c->GetManifold()->points[0].normalImpulse = 50.0f * wedge.ball->GetMass();
    }
    wedge.ball->SetLinearVelocity(b2Vec2(0.0f, 20.0f));
    wedge.Step();
    EXPECT_NEAR(wedge.ball->GetLinearVelocity().y, 20.0f, 0.01f);
}

} // namespace
