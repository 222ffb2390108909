// SPDX-License-Identifier: MIT
#include "DynamicsMisuse.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>

/// Bodies that move freely, rest, slide or collide in steps with sub-steps.
namespace
{

using namespace dynamics;

TEST(SubStepIterations, AreDividedAmongSubStepsButAtLeastOne)
{
    EXPECT_EQ(b2IterationsOfASubStep(8, 4), 2);
    EXPECT_EQ(b2IterationsOfASubStep(3, 4), 1);
    EXPECT_EQ(b2IterationsOfASubStep(50, 16), 3);
    EXPECT_EQ(b2IterationsOfASubStep(0, 2), 1);
    EXPECT_EQ(b2IterationsOfASubStep(8, 1), 8);
    EXPECT_EQ(b2IterationsOfASubStep(0, 1), 0) << "the manual's scheme takes what it is given";
}

TEST(SubSteps, DefaultToOneAndRangeFrom1To64)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    EXPECT_EQ(world.GetSubStepCount(), 1);
    world.SetSubStepCount(4);
    EXPECT_EQ(world.GetSubStepCount(), 4);
    world.SetSubStepCount(64);
    EXPECT_EQ(world.GetSubStepCount(), 64);
    ExpectMisuse("from 1 to 64", [&] { world.SetSubStepCount(0); });
    ExpectMisuse("from 1 to 64", [&] { world.SetSubStepCount(65); });
}

TEST(SubSteps, MoveAFallingBodyOnAParabolaForAnyCount)
{
    for (const int32 count : {2, 3, 4, 16})
    {
        Scene scene;
        scene.world.SetSubStepCount(count);
        b2Body* ball = scene.Ball(0.0f, 0.0f);
        ball->SetLinearVelocity(b2Vec2(10.0f, 20.0f));
        ball->SetAngularVelocity(3.0f);
        for (int i = 1; i <= 120; ++i)
        {
            scene.Step();
            const double t = double(i) / 60.0;
            EXPECT_NEAR(double(ball->GetPosition().x), 10.0 * t, 1e-4) << count;
            EXPECT_NEAR(double(ball->GetPosition().y), 20.0 * t - 5.0 * t * t, 1e-4) << count;
        }
        EXPECT_NEAR(ball->GetLinearVelocity().y, 0.0f, 1e-4f);
        EXPECT_NEAR(ball->GetAngle(), 6.0f, 1e-4f);
    }
}

TEST(SubSteps, ApplyForcesAndTorquesForTheWholeStep)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetSubStepCount(4);
    b2Body* box = scene.Box(0.0f, 0.0f);
    for (int i = 0; i < 60; ++i)
    {
        box->ApplyForceToCenter(b2Vec2(3.0f, 0.0f));
        box->ApplyTorque(0.5f);
        scene.Step();
    }
    EXPECT_NEAR(box->GetLinearVelocity().x, 3.0f / box->GetMass(), 1e-4f);
    EXPECT_NEAR(box->GetPosition().x, 1.5f / box->GetMass(), 1e-4f);
    EXPECT_NEAR(box->GetAngularVelocity(), 0.5f / box->GetInertia(), 1e-3f);
}

TEST(SubSteps, DampVelocitiesExponentially)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetSubStepCount(4);
    b2Body* ball = scene.Ball(0.0f, 0.0f);
    ball->SetLinearDamping(2.0f);
    ball->SetAngularDamping(1.0f);
    ball->SetLinearVelocity(b2Vec2(8.0f, 0.0f));
    ball->SetAngularVelocity(5.0f);
    scene.Step(60);
    EXPECT_NEAR(ball->GetLinearVelocity().x, 8.0f * std::exp(-2.0f), 1e-4f);
    EXPECT_NEAR(ball->GetAngularVelocity(), 5.0f * std::exp(-1.0f), 1e-4f);
    EXPECT_NEAR(ball->GetPosition().x, 4.0f * (1.0f - std::exp(-2.0f)), 1e-3f);
}

TEST(SubSteps, ReachTheTerminalSpeedWithDamping)
{
    Scene scene;
    scene.world.SetSubStepCount(4);
    b2Body* ball = scene.Ball(0.0f, 0.0f);
    ball->SetLinearDamping(5.0f);
    scene.Step(300);
    EXPECT_NEAR(ball->GetLinearVelocity().y, -2.0f, 1e-4f);
}

TEST(SubSteps, KeepRestingBodiesAtRest)
{
    Scene scene;
    scene.world.SetSubStepCount(4);
    scene.world.SetAllowSleeping(false);
    scene.Ground();
    const std::vector<b2Body*> boxes = Stack(scene, 0.0f, 3);
    scene.Step(60);
    const b2Vec2 place = boxes[2]->GetPosition();
    for (int i = 0; i < 120; ++i)
    {
        scene.Step();
        EXPECT_LT(boxes[2]->GetLinearVelocity().Length(), 1e-4f);
    }
    EXPECT_LT(b2Distance(boxes[2]->GetPosition(), place), 1e-4f);
}

TEST(SubSteps, MoveASlowBodyFarFromTheOrigin)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetSubStepCount(4);
    b2Body* ball = scene.Ball(10000.0f, 0.0f);
    ball->SetSleepingAllowed(false);
    ball->SetLinearVelocity(b2Vec2(0.02f, 0.0f));
    scene.Step(3600);
    EXPECT_NEAR(ball->GetPosition().x, 10001.2f, 0.002f);
}

TEST(SubSteps, SlideDownASlopeByCoulombFriction)
{
    for (const int32 count : {2, 4, 8})
    {
        Scene scene;
        scene.world.SetSubStepCount(count);
        const float32 slope = b2_pi / 6.0f;
        const b2Vec2 down(std::cos(slope), -std::sin(slope));
        b2EdgeShape edge;
        edge.Set(-5.0f * down, 60.0f * down);
        Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), edge, 0.3f, 0.0f);
        const b2Vec2 start = 0.5f * b2Vec2(std::sin(slope), std::cos(slope));
        b2Body* box = scene.Body(b2_dynamicBody, start.x, start.y, -slope);
        Scene::AddBox(box, 0.5f, 0.5f, 0.3f);
        scene.Step(120);
        const float32 way = b2Dot(box->GetPosition() - start, down);
        const float32 acceleration = 10.0f * (std::sin(slope) - 0.3f * std::cos(slope));
        EXPECT_NEAR(way / (2.0f * acceleration), 1.0f, 1e-5f) << count;
    }
}

/// Returns the apexes of a ball dropped from 10 m, after each of its first impacts.
std::vector<float32> Apexes(float32 restitution, int32 subSteps, int count)
{
    Scene scene;
    scene.world.SetSubStepCount(subSteps);
    b2EdgeShape edge;
    edge.Set(b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
    Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), edge, 0.2f, restitution);
    b2Body* ball = scene.Body(b2_dynamicBody, 0.0f, 10.5f);
    Scene::AddBall(ball, 0.5f, 0.2f, restitution);
    std::vector<float32> apexes;
    float32 highest = 0.0f;
    bool rose = false;
    while (apexes.size() < std::size_t(count))
    {
        scene.Step();
        const bool rises = ball->GetLinearVelocity().y > 0.0f;
        highest = rises && !rose ? 0.0f : b2Max(highest, ball->GetPosition().y - 0.5f);
        if (rose && !rises)
        {
            apexes.push_back(highest);
        }
        rose = rises;
    }
    return apexes;
}

TEST(SubSteps, ReturnAnElasticBallToItsHeight)
{
    for (const int32 count : {2, 4, 8})
    {
        for (const float32 apex : Apexes(1.0f, count, 20))
        {
            EXPECT_NEAR(apex, 10.0f, 0.01f) << count;
        }
    }
}

TEST(SubSteps, ApplyRestitutionOncePerImpact)
{
    const std::vector<float32> apexes = Apexes(0.5f, 4, 2);
    EXPECT_NEAR(apexes[0] / 2.5f, 1.0f, 0.002f);
    EXPECT_NEAR(apexes[1] / 0.625f, 1.0f, 0.005f);
}

TEST(SubSteps, TransferAnImpactThroughARowOfBalls)
{
    for (const float32 direction : {1.0f, -1.0f})
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        scene.world.SetSubStepCount(4);
        std::vector<b2Body*> balls;
        for (int i = 0; i < 6; ++i)
        {
            b2Body* ball =
                scene.Body(b2_dynamicBody, direction * (i == 0 ? -4.0f : float32(i)), 0.0f);
            Scene::AddBall(ball, 0.5f, 0.0f, 1.0f);
            balls.push_back(ball);
        }
        balls[0]->SetLinearVelocity(b2Vec2(direction * 10.0f, 0.0f));
        scene.Step(60);
        for (int i = 0; i < 5; ++i)
        {
            EXPECT_NEAR(balls[std::size_t(i)]->GetLinearVelocity().Length(), 0.0f, 1e-4f) << i;
        }
        EXPECT_NEAR(balls[5]->GetLinearVelocity().x, direction * 10.0f, 1e-3f);
    }
}

TEST(SubSteps, KeepTheEnergyOfAGasBetweenThinWalls)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetSubStepCount(4);
    b2Body* walls = scene.Body(b2_staticBody, 0.0f, 0.0f);
    for (const float32 side : {-1.0f, 1.0f})
    {
        b2PolygonShape shape;
        shape.SetAsBox(8.1f, 0.05f, b2Vec2(0.0f, 8.05f * side), 0.0f);
        Scene::Add(walls, shape, 0.0f, 1.0f);
        shape.SetAsBox(0.05f, 8.1f, b2Vec2(8.05f * side, 0.0f), 0.0f);
        Scene::Add(walls, shape, 0.0f, 1.0f);
    }
    std::vector<b2Body*> balls;
    for (int i = 0; i < 60; ++i)
    {
        b2Body* ball = scene.Body(b2_dynamicBody, -6.5f + 1.4f * float32(i % 10),
                                  -5.0f + 1.7f * float32(i / 10));
        Scene::AddBall(ball, 0.1f, 0.0f, 1.0f);
        ball->SetLinearVelocity(200.0f * b2Vec2(std::cos(float32(i)), std::sin(float32(i))));
        balls.push_back(ball);
    }
    scene.Step(300);
    double sum = 0.0;
    for (const b2Body* ball : balls)
    {
        EXPECT_LT(b2Abs(ball->GetPosition().x), 8.1f);
        EXPECT_LT(b2Abs(ball->GetPosition().y), 8.1f);
        sum += double(ball->GetLinearVelocity().LengthSquared());
    }
    EXPECT_NEAR(sum / (60.0 * 200.0 * 200.0), 1.0, 0.001);
}

TEST(SubSteps, CanBeSwitchedOnAndOffWhileAStackRests)
{
    Scene scene;
    scene.Ground();
    const std::vector<b2Body*> boxes = Stack(scene, 0.0f, 6);
    for (const int32 count : {4, 1, 8, 2, 1, 4})
    {
        scene.world.SetSubStepCount(count);
        for (b2Body* box : boxes)
        {
            box->SetAwake(true);
        }
        scene.Step(20);
        EXPECT_LT(boxes[5]->GetLinearVelocity().Length(), 0.02f) << count;
        EXPECT_NEAR(boxes[5]->GetPosition().x, 0.0f, 0.001f) << count;
    }
}

} // namespace
