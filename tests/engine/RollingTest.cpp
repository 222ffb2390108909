// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// Contacts whose normals and levers turn within a step.
namespace
{

using namespace dynamics;

/// A ball with a weight off its centre that rocks on a flat edge.
struct RockingBall : Scene
{
    RockingBall(int32 subSteps, float32 friction)
    {
        world.SetSubStepCount(subSteps);
        b2EdgeShape ground;
        ground.Set(b2Vec2(-500.0f, 0.0f), b2Vec2(500.0f, 0.0f));
        Add(Body(b2_staticBody, 0.0f, 0.0f), ground, friction, 0.0f);
        ball = Body(b2_dynamicBody, 0.0f, 1.0f, 1.0f);
        AddBall(ball, 1.0f, friction);
        b2CircleShape weight;
        weight.m_radius = 0.3f;
        weight.m_p.Set(0.0f, -0.6f);
        ball->CreateFixture(&weight, 20.0f);
    }

    double Energy() const // [J], from the lowest place on
    {
        const double mass = ball->GetMass();
        const double offset = ball->GetLocalCenter().Length();
        const double inertia = ball->GetInertia() - mass * offset * offset;
        const double speed = ball->GetAngularVelocity();
        const double height = double(ball->GetWorldCenter().y) - 1.0 + offset;
        return 0.5 * mass * double(ball->GetLinearVelocity().LengthSquared()) +
               0.5 * inertia * speed * speed - double(world.GetGravity().y) * mass * height;
    }

    b2Body* ball;
};

/// With normals and levers from the start of the step it went up to 44 J, with any number.
TEST(Rolling, GainsNoEnergyWhereAWeightRocksABall)
{
    for (const int32 subSteps : {1, 2, 4, 8, 16})
    {
        for (const float32 friction : {0.0f, 1.0f})
        {
            RockingBall scene(subSteps, friction);
            const double first = scene.Energy();
            double most = 0.0;
            for (int i = 0; i < 1200; ++i)
            {
                scene.Step();
                most = std::max(most, scene.Energy());
            }
            EXPECT_LT(most, 1.07 * first) << subSteps << " sub-steps, friction " << friction;
            EXPECT_GT(scene.Energy(), 0.6 * first) << subSteps << ", friction " << friction;
        }
    }
}

/// Both of its contacts must be turned as one pair of bodies. Turned apart they were like walls
/// that close, and threw the box out at up to 10 km/s.
TEST(Rolling, LeavesABoxInATiltingTray)
{
    for (const int32 subSteps : {2, 4, 8, 16})
    {
        for (int32 start = 0; start < 4; ++start)
        {
            Scene scene;
            scene.world.SetSubStepCount(subSteps);
            b2Body* tray = scene.Body(b2_kinematicBody, 0.0f, 0.0f);
            for (const float32 side : {-1.0f, 1.0f})
            {
                b2PolygonShape wall;
                wall.SetAsBox(0.1f, 2.0f, b2Vec2(0.9f * side, 1.0f), -0.5f * side);
                Scene::Add(tray, wall, 0.8f, 0.0f);
            }
            b2Body* box = scene.Body(b2_dynamicBody, 0.0f, 0.9f, 0.1f * float32(start));
            Scene::AddBox(box, 0.4f, 0.4f, 0.8f);
            for (int32 i = 0; i < 600; ++i)
            {
                tray->SetAngularVelocity(0.3f * b2_pi *
                                         std::cos(2.0f * b2_pi * (float32(i) + 0.5f) / 60.0f));
                scene.Step();
                ASSERT_LT(box->GetLinearVelocity().Length(), 4.0f) << subSteps << ", " << start;
            }
        }
    }
}

/// A disc that spins on a hill, whose body may have its origin anywhere. The disc is the first body
/// of the contact. Moved on in its own frame, the far centre of the hill went astray. With 1 to
/// 16 sub-steps the disc has 3.944 to 3.951 m/s; with normals from the start of the step it had
/// 4.006.
TEST(Rolling, DoesNotDependOnWhereTheGroundHasItsOrigin)
{
    for (const int32 subSteps : {2, 4, 8})
    {
        b2Vec2 speeds[2];
        for (int32 i = 0; i < 2; ++i)
        {
            const b2Vec2 origin(0.0f, i == 0 ? 0.0f : -300.0f);
            Scene scene;
            scene.world.SetSubStepCount(subSteps);
            b2Body* disc = scene.Ball(0.0f, 0.52f, 0.5f);
            disc->GetFixtureList()->SetFriction(0.5f);
            disc->SetAngularVelocity(-20.0f);
            b2CircleShape hill;
            hill.m_radius = 50.0f;
            hill.m_p = b2Vec2(0.0f, -50.0f) - origin;
            Scene::Add(scene.Body(b2_staticBody, origin.x, origin.y), hill, 0.5f, 0.0f);
            scene.Step(120);
            speeds[i] = disc->GetLinearVelocity();
        }
        for (const b2Vec2& speed : speeds)
        {
            EXPECT_NEAR(speed.x, 3.95f, 0.02f) << subSteps;
            EXPECT_NEAR(speed.y, -0.46f, 0.01f) << subSteps;
        }
    }
}

/// By the middle of the step it would be past the other one. With the normal from there the blow
/// drove them into each other, by 86 of 100 mm.
TEST(Rolling, StopsABallThatIsThrownAtTheOneBelow)
{
    for (const int32 subSteps : {2, 4, 8, 16})
    {
        for (const float32 speed : {12.0f, 20.0f, 50.0f})
        {
            Scene scene;
            scene.world.SetSubStepCount(subSteps);
            b2Body* below = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
            scene.AddBall(below, 0.05f, 0.5f);
            b2Body* ball = scene.Body(b2_dynamicBody, 0.0f, 0.1f);
            scene.AddBall(ball, 0.05f, 0.5f);
            b2Body* ground = scene.Body(b2_staticBody, 0.0f, 0.0f);
            for (const float32 side : {-0.05f, 0.05f}) // a tube, closed below
            {
                b2EdgeShape wall;
                wall.Set(b2Vec2(side, -0.05f), b2Vec2(side, 1.0f));
                scene.Add(ground, wall, 0.0f, 0.0f);
            }
            b2EdgeShape floor;
            floor.Set(b2Vec2(-0.05f, -0.05f), b2Vec2(0.05f, -0.05f));
            scene.Add(ground, floor, 0.0f, 0.0f);
            scene.Step(60);
            ball->SetLinearVelocity(b2Vec2(0.0f, -speed));
            scene.Step(30);
            const float32 apart = (ball->GetPosition() - below->GetPosition()).Length();
            EXPECT_GT(apart, 0.1f - 2.0f * b2_linearSlop) << subSteps << ", " << speed << " m/s";
        }
    }
}

/// The circle's own turn was not counted: its contact turned over, and the ball went 45 mm into it
/// and off to the side.
TEST(Rolling, ThrowsABallAtTheEndOfAnArmWhereTheArmGoes)
{
    for (const int32 subSteps : {1, 2, 4, 8})
    {
        for (const float32 speed : {4.0f, 6.0f, 8.0f})
        {
            Scene scene(b2Vec2_zero);
            scene.world.SetSubStepCount(subSteps);
            b2Body* arm = scene.Body(b2_kinematicBody, 0.0f, 0.0f);
            b2CircleShape end;
            end.m_radius = 0.05f;
            end.m_p.Set(5.0f, 0.0f);
            arm->CreateFixture(&end, 0.0f);
            b2Body* ball = scene.Body(b2_dynamicBody, 5.0f, -0.1f);
            scene.AddBall(ball, 0.05f, 0.0f);
            for (int i = 0; i < 10; ++i)
            {
                ball->ApplyForceToCenter(b2Vec2(0.0f, 0.5f));
                scene.Step();
            }
            arm->SetAngularVelocity(-speed);
            scene.Step();
            const b2Vec2 v = ball->GetLinearVelocity();
            EXPECT_NEAR(v.y, -5.0f * speed, 0.1f) << subSteps << ", " << speed << " rad/s";
            EXPECT_NEAR(v.x, 0.0f, 0.5f) << subSteps << ", " << speed << " rad/s";
            const b2Vec2 apart = ball->GetPosition() - arm->GetWorldPoint(end.m_p);
            EXPECT_GT(apart.Length(), 0.1f - 2.0f * b2_linearSlop) << subSteps << ", " << speed;
        }
    }
}

} // namespace
