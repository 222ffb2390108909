// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>

/// A body pressed against a wall stays on its side, and an impact does not add energy.
namespace
{

using namespace dynamics;

class Containment : public testing::TestWithParam<int32>
{};

b2Fixture* AddEdge(b2Body* body, const b2Vec2& from, const b2Vec2& to)
{
    b2EdgeShape edge;
    edge.Set(from, to);
    return Scene::Add(body, edge, 0.3f, 0.0f);
}

/// Light bullets of all angles between a wall without thickness and a heavy box that falls on them.
/// More walls may stand behind it, nearer to each other than the bullets are thick.
void Press(int32 subSteps, b2BodyType type, float32 wallSpeed, int32 walls = 1)
{
    for (int i = 0; i < 40; ++i)
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        scene.world.SetSubStepCount(subSteps);
        b2Body* wall = scene.Body(type, 5.0f, 0.0f);
        for (int32 k = 0; k < walls; ++k)
        {
            const float32 x = 0.05f * float32(k);
            AddEdge(wall, b2Vec2(x, -1000.0f), b2Vec2(x, 1000.0f));
        }
        wall->SetLinearVelocity(b2Vec2(wallSpeed, 0.0f));
        b2Body* light =
            scene.Body(b2_dynamicBody, 3.9f, 0.03f * float32(i % 10), 0.17f * float32(i));
        Scene::AddBox(light, 0.7f, 0.2f);
        light->SetBullet(true);
        light->SetLinearVelocity(b2Vec2(10.0f, 0.0f));
        b2Body* heavy = scene.Body(b2_dynamicBody, 2.5f, 0.0f, 0.3f * float32(i));
        Scene::AddBox(heavy, 0.3f, 0.2f);
        b2MassData mass;
        heavy->GetMassData(&mass);
        mass.mass *= 300.0f;
        mass.I *= 300.0f;
        heavy->SetMassData(&mass);
        heavy->SetLinearVelocity(b2Vec2(15.0f, 0.0f));
        for (int step = 0; step < 180; ++step)
        {
            heavy->ApplyForceToCenter(b2Vec2(30.0f * heavy->GetMass(), 0.0f), true);
            scene.world.Step(kStep, 4, 2);
            ASSERT_LT(light->GetPosition().x, wall->GetPosition().x) << i << ", step " << step;
            ASSERT_LT(heavy->GetPosition().x, wall->GetPosition().x) << i << ", step " << step;
        }
    }
}

TEST_P(Containment, KeepsALightBodyBetweenAThinWallAndAPress)
{
    Press(GetParam(), b2_staticBody, 0.0f);
}

TEST_P(Containment, KeepsALightBodyBeforeAMovingWall)
{
    Press(GetParam(), b2_kinematicBody, -1.0f);
}

TEST_P(Containment, KeepsALightBodyBeforeTheFirstOfSeveralWalls)
{
    Press(GetParam(), b2_staticBody, 0.0f, 4);
}

TEST_P(Containment, LetsBodiesPassWhenTheListenerDisablesContacts)
{
    struct OneWay : b2ContactListener
    {
        void PreSolve(b2Contact* contact, const b2Manifold*) override
        {
            contact->SetEnabled(false);
        }
    } listener;
    Scene scene;
    scene.world.SetSubStepCount(GetParam());
    scene.world.SetContactListener(&listener);
    AddEdge(scene.Body(b2_staticBody, 0.0f, 0.0f), b2Vec2(-5.0f, 0.0f), b2Vec2(5.0f, 0.0f));
    b2Body* ball = scene.Ball(0.0f, 2.0f, 0.3f);
    for (int step = 0; step < 120; ++step)
    {
        scene.world.Step(kStep, 8, 3);
    }
    EXPECT_LT(ball->GetPosition().y, -5.0f);
}

// The centre of mass is between the shapes, where there may be a wall. This one is slanted, so that
// the boxes around it and the shapes overlap, and they are looked at.
TEST_P(Containment, LetsABodyMoveThatHasAWallBetweenItsShapes)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetSubStepCount(GetParam());
    AddEdge(scene.Body(b2_staticBody, 0.0f, 0.0f), b2Vec2(-10.0f, -10.0f), b2Vec2(10.0f, 10.0f));
    const b2Vec2 away = std::sqrt(0.5f) * b2Vec2(-1.0f, 1.0f);
    b2Body* body = scene.Body(b2_dynamicBody, 0.2f * away.x, 0.2f * away.y);
    for (const float32 side : {-1.0f, 1.0f})
    {
        b2CircleShape ball;
        ball.m_p = side * away;
        ball.m_radius = 0.4f;
        Scene::Add(body, ball, 0.0f, 0.0f);
    }
    body->SetLinearVelocity(-0.5f * away);
    for (int step = 0; step < 40; ++step)
    {
        scene.world.Step(kStep, 8, 3);
    }
    EXPECT_EQ(scene.world.GetContactCount(), 2);
    EXPECT_LT(b2Dot(body->GetPosition(), away), -0.1f);
    EXPECT_NEAR(b2Dot(body->GetLinearVelocity(), away), -0.5f, 1e-4f);
}

/// Rods that spin, thrown at a rough wall that throws them back.
TEST_P(Containment, GainsNoEnergyByFrictionInImpacts)
{
    double widest = 0.0;
    for (int i = 0; i < 200; ++i)
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        scene.world.SetSubStepCount(GetParam());
        b2Body* wall = scene.Body(b2_staticBody, 5.0f, 0.0f);
        AddEdge(wall, b2Vec2(0.0f, -50.0f), b2Vec2(0.0f, 50.0f))->SetFriction(0.9f);
        b2Body* rod = scene.Body(b2_dynamicBody, 0.0f, 0.0f, 0.1f * float32(i));
        Scene::AddBox(rod, 0.6f, 0.05f, 0.9f, 0.8f);
        rod->SetLinearVelocity(b2Vec2(40.0f, -30.0f + 0.3f * float32(i)));
        rod->SetAngularVelocity(-20.0f + 0.2f * float32(i));
        const auto energy = [&] {
            return 0.5 * double(rod->GetMass()) * double(rod->GetLinearVelocity().LengthSquared()) +
                   0.5 * double(rod->GetInertia()) * double(rod->GetAngularVelocity()) *
                       double(rod->GetAngularVelocity());
        };
        double before = energy();
        for (int step = 0; step < 40; ++step)
        {
            scene.world.Step(kStep, 8, 3);
            widest = std::fmax(widest, energy() / before - 1.0);
            before = energy();
        }
    }
    EXPECT_LT(widest, 1e-3);
}

/// Rods that lie in a floor and spin: one end comes out of it, where they touch, while the other
/// goes in.
TEST_P(Containment, KeepsTheOtherEndOfATurningRodOutOfAWall)
{
    constexpr float32 kHalf = 1.0f;
    for (int i = 0; i < 20; ++i)
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        scene.world.SetSubStepCount(GetParam());
        AddEdge(scene.Body(b2_staticBody, 0.0f, 0.0f), b2Vec2(-50.0f, 0.0f), b2Vec2(50.0f, 0.0f));
        b2Body* rod = scene.Body(b2_dynamicBody, 0.0f, 0.06f, -0.05f);
        Scene::AddBox(rod, kHalf, 0.05f);
        rod->SetAngularVelocity(20.0f + 2.0f * float32(i)); // [rad/s]
        for (int step = 0; step < 10; ++step)
        {
            scene.world.Step(kStep, 8, 3);
            for (const float32 end : {-kHalf, kHalf})
            {
                EXPECT_GT(rod->GetWorldPoint(b2Vec2(end, 0.0f)).y, -0.1f) << i << ", step " << step;
            }
        }
    }
}

/// A light tip far out on a heavy, spinning body hits a wall. On its own it would spin at hundreds
/// of radians a second. It must not rotate the heavy body with it.
TEST_P(Containment, KeepsOutAHeavyBodyWhoseLightTipIsStopped)
{
    constexpr float32 kWall = 4.0f;
    constexpr float32 kHalf = 0.8f;
    float32 farthest = -kWall; // of the heavy body's corners beyond the wall [m]
    for (int i = 0; i < 300; ++i)
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        scene.world.SetSubStepCount(GetParam());
        AddEdge(scene.Body(b2_staticBody, kWall, 0.0f), b2Vec2(0.0f, -50.0f), b2Vec2(0.0f, 50.0f));
        b2Body* heavy = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
        Scene::AddBox(heavy, kHalf, kHalf, 40.0f);
        b2Body* tip = scene.Body(b2_dynamicBody, 2.5f, 0.0f);
        Scene::AddBox(tip, 0.2f, 0.05f, 25.0f);
        b2WeldJointDef weld;
        weld.Initialize(heavy, tip, heavy->GetPosition());
        scene.world.CreateJoint(&weld);
        const b2Rot turn(-0.02f * float32(i));
        for (b2Body* body : {heavy, tip})
        {
            body->SetTransform(b2Mul(turn, body->GetPosition()), turn.GetAngle());
            body->SetAngularVelocity(20.0f); // [rad/s]
            body->SetLinearVelocity(b2Vec2(7.0f, 0.0f) + b2Cross(20.0f, body->GetPosition()));
        }
        for (int step = 0; step < 20; ++step)
        {
            scene.world.Step(kStep, 8, 3);
            for (const float32 x : {-kHalf, kHalf})
            {
                for (const float32 y : {-kHalf, kHalf})
                {
                    farthest = b2Max(farthest, heavy->GetWorldPoint(b2Vec2(x, y)).x - kWall);
                }
            }
        }
    }
    EXPECT_LT(farthest, 0.4f);
}

/// An obstacle in front of an upright wall at x = 0.
struct Obstacle
{
    const char* name;
    bool isEdge;
    b2Vec2 place, velocity;
};

/// A ball bounces off the wall and ends behind the obstacle. The straight line from its start to
/// its end crosses the obstacle, but its path does not.
void GoRound(int32 subSteps, const Obstacle& obstacle)
{
    SCOPED_TRACE(obstacle.name);
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetSubStepCount(subSteps);
    b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
    AddEdge(wall, b2Vec2(0.0f, -50.0f), b2Vec2(0.0f, 50.0f))->SetRestitution(1.0f);
    const bool moves = obstacle.velocity != b2Vec2(0.0f, 0.0f);
    b2Body* before =
        scene.Body(moves ? b2_kinematicBody : b2_staticBody, obstacle.place.x, obstacle.place.y);
    obstacle.isEdge ? AddEdge(before, b2Vec2(-0.19f, 0.0f), b2Vec2(0.19f, 0.0f))
                    : Scene::AddBox(before, 0.19f, 0.15f);
    before->SetLinearVelocity(obstacle.velocity);
    b2Body* ball = scene.Body(b2_dynamicBody, 0.7f, 0.67f);
    Scene::AddBall(ball, 0.1f, 0.0f, 1.0f);
    ball->SetLinearVelocity(b2Vec2(-80.0f, -80.0f));
    scene.Step();
    EXPECT_NEAR(ball->GetLinearVelocity().x, 80.0f, 1e-3f);
    EXPECT_NEAR(ball->GetLinearVelocity().y, -80.0f, 1e-3f);
    EXPECT_NEAR(ball->GetPosition().y, 0.67f - 80.0f * kStep, 1e-3f);
}

TEST_P(Containment, LetsABodyGoRoundAnObstacleWithinAStep)
{
    const b2Vec2 still(0.0f, 0.0f);
    GoRound(GetParam(), {"box", false, b2Vec2(0.75f, 0.0f), still});
    GoRound(GetParam(), {"edge", true, b2Vec2(0.75f, 0.0f), still});
    // It goes down with the ball, which is above it first, and then below.
    GoRound(GetParam(), {"edge that moves", true, b2Vec2(0.81f, 0.52f), b2Vec2(0.0f, -60.0f)});
}

INSTANTIATE_TEST_SUITE_P(SubSteps, Containment, testing::Values(1, 2, 4));

} // namespace
