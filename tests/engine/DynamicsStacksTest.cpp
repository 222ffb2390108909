// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// Stacks that are too high for a few iterations, and chains that carry too much. They give way a
/// little, but not to one side.
namespace
{

using dynamics::Scene;

/// Boxes of half a metre in rows, each shifted by half a box against the one below.
void AddPyramid(Scene& scene, int32 base)
{
    Scene::AddBox(scene.Body(b2_staticBody, 0.0f, -1.0f), 100.0f, 1.0f, 0.6f);
    for (int32 row = 0; row < base; ++row)
    {
        const int32 count = base - row;
        for (int32 i = 0; i < count; ++i)
        {
            const float32 x = 0.5f * float32(2 * i - (count - 1));
            Scene::AddBox(scene.Body(b2_dynamicBody, x, 0.5f + float32(row)), 0.5f, 0.5f, 0.6f);
        }
    }
}

/// Over all points that touch [m].
float32 MeanOverlap(b2World& world)
{
    float32 sum = 0.0f;
    int32 count = 0;
    for (b2Contact* contact = world.GetContactList(); contact; contact = contact->GetNext())
    {
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        for (int32 i = 0; contact->IsTouching() && i < contact->GetManifold()->pointCount; ++i)
        {
            sum += b2Max(-manifold.separations[i], 0.0f);
            ++count;
        }
    }
    return sum / float32(std::max(count, 1));
}

/// Returns the distance of the mean of all bodies from the middle [m].
float32 Drift(b2World& world)
{
    float32 sum = 0.0f;
    for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext())
    {
        sum += body->GetPosition().x;
    }
    return std::abs(sum) / float32(world.GetBodyCount());
}

TEST(DynamicsStacks, KeepATallPyramidStraightWithLittleOverlap)
{
    Scene scene;
    scene.world.SetAllowSleeping(false);
    AddPyramid(scene, 60);
    float32 overlap = 0.0f;
    float32 drift = 0.0f;
    for (int32 i = 0; i < 300; ++i)
    {
        scene.world.Step(dynamics::kStep, 8, 3);
        overlap = i < 60 ? 0.0f : b2Max(overlap, MeanOverlap(scene.world));
        drift = b2Max(drift, Drift(scene.world));
    }
    // Sweeps that turn every time give 29 mm and 9 cm, forward ones 18 mm and 43 cm, these 23 mm
    // and half a centimetre.
    EXPECT_LT(overlap, 0.026f);
    EXPECT_LT(drift, 0.03f);
}

/// The widest gap that opens in any hinge [m].
float32 WidestGap(const std::vector<b2Joint*>& hinges)
{
    float32 widest = 0.0f;
    for (const b2Joint* hinge : hinges)
    {
        widest = b2Max(widest, (hinge->GetAnchorA() - hinge->GetAnchorB()).Length());
    }
    return widest;
}

TEST(DynamicsChain, OpensItsHingesLittleUnderAHeavyBall)
{
    Scene scene;
    b2Body* last = scene.Body(b2_staticBody, 0.0f, 0.0f);
    std::vector<b2Joint*> hinges;
    for (int32 i = 0; i < 20; ++i)
    {
        b2Body* link = scene.Body(b2_dynamicBody, 0.0f, -0.5f - float32(i));
        Scene::AddBox(link, 0.125f, 0.5f)->SetSensor(true);
        b2RevoluteJointDef def;
        def.Initialize(last, link, b2Vec2(0.0f, -float32(i)));
        hinges.push_back(scene.world.CreateJoint(&def));
        last = link;
    }
    b2CircleShape ball;
    ball.m_radius = 1.0f;
    ball.m_p.Set(0.0f, -1.5f);
    last->CreateFixture(&ball, 25.0f / b2_pi)->SetSensor(true); // a hundred links
    float32 widest = 0.0f;
    for (int32 i = 0; i < 600; ++i)
    {
        scene.Step();
        widest = b2Max(widest, WidestGap(hinges));
    }
    // Sweeps that turn every time give 113 mm, forward ones 72.
    EXPECT_LT(widest, 0.08f);
}

/// Balls of 1 m that fall at 50 m/s: what touches the ground when a step begins must not be pushed
/// through it by what falls on it.
TEST(DynamicsStacks, KeepFastBallsAboveTheGround)
{
    Scene scene;
    b2EdgeShape line;
    line.Set(b2Vec2(-40.0f, 0.0f), b2Vec2(40.0f, 0.0f));
    scene.Body(b2_staticBody, 0.0f, 0.0f)->CreateFixture(&line, 0.0f);
    std::vector<b2Body*> balls;
    for (int32 i = 0; i < 10; ++i)
    {
        balls.push_back(scene.Ball(0.0f, 4.0f + 3.0f * float32(i), 1.0f));
        balls.back()->SetLinearVelocity(b2Vec2(0.0f, -50.0f));
    }
    float32 lowest = 1.0f;
    for (int32 step = 0; step < 120; ++step)
    {
        scene.world.Step(dynamics::kStep, 8, 3);
        lowest = b2Min(lowest, balls[0]->GetPosition().y);
    }
    EXPECT_GT(lowest, 1.0f - 3.0f * b2_linearSlop);
}

} // namespace
