// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsMisuse.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <random>

/// Numbers near the limits of floats. No result may be NaN, and the world must recover after
/// extreme values.
namespace
{

using namespace dynamics;

TEST(DynamicsExtremes, MoveBodiesFreelyWithZeroIterations)
{
    Scene scene;
    b2Body* box = scene.Box(0.0f, 5.0f);
    scene.world.Step(kStep, 0, 0);
    EXPECT_NEAR(box->GetLinearVelocity().y, -10.0f * kStep, 1e-6f);
}

TEST(DynamicsExtremes, UpdateContactsOnlyInAStepOfZero)
{
    Scene scene;
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.505f);
    scene.world.Step(0.0f, 8, 3);
    EXPECT_EQ(box->GetPosition(), b2Vec2(0.0f, 0.505f));
    ASSERT_NE(box->GetContactList(), nullptr);
    EXPECT_TRUE(box->GetContactList()->contact->IsTouching());
}

Scene* MachineWithEverything()
{
    auto* scene = new Scene;
    b2Body* ground = scene->Ground();
    Stack(*scene, 0.0f, 4);
    b2Body* last = ground;
    for (int i = 0; i < 4; ++i)
    {
        b2Body* link = scene->Box(5.0f + float32(i), 4.0f, 0.5f, 0.1f);
        b2RevoluteJointDef def;
        def.Initialize(last, link, b2Vec2(4.5f + float32(i), 4.0f));
        def.enableMotor = i == 1;
        def.motorSpeed = 3.0f;
        def.maxMotorTorque = 100.0f;
        def.enableLimit = i == 2;
        def.lowerAngle = -0.5f;
        def.upperAngle = 0.5f;
        scene->world.CreateJoint(&def);
        last = link;
    }
    b2DistanceJointDef spring;
    spring.Initialize(ground, last, b2Vec2(8.5f, 9.0f), last->GetPosition());
    spring.frequencyHz = 2.0f;
    scene->world.CreateJoint(&spring);
    b2Body* ball = scene->Ball(-5.0f, 3.0f, 0.2f);
    ball->SetBullet(true);
    ball->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    return scene;
}

TEST(DynamicsExtremes, KeepTheWorldFiniteInStepsOfAnyLength)
{
    const float32 steps[] = {1e-45f, 1e-38f, 1e-30f, 1e-20f, 1e-10f,
                             1e-5f,  0.5f,   10.0f,  1e4f,   1e5f};
    for (const float32 step : steps)
    {
        const std::unique_ptr<Scene> scene(MachineWithEverything());
        for (int i = 0; i < 20; ++i)
        {
            scene->world.Step(i % 3 == 0 ? kStep : step, 8, 3);
            ASSERT_EQ(WhyBroken(scene->world, false), "") << step << ", step " << i;
        }
    }
}

TEST(DynamicsExtremes, KeepTheWorldFiniteWithHugeNumbers)
{
    std::mt19937 random(11);
    const auto huge = [&] {
        const float32 sizes[] = {1.0f, 1e3f, 1e10f, 1e19f, 1e30f, FLT_MAX};
        return (random() % 2 == 0 ? 1.0f : -1.0f) * sizes[random() % 6];
    };
    for (int round = 0; round < 60; ++round)
    {
        const std::unique_ptr<Scene> scene(MachineWithEverything());
        for (int i = 0; i < 30; ++i)
        {
            b2Body* body = scene->world.GetBodyList();
            for (auto skip = random() % 10; skip > 0; --skip)
            {
                body = body->GetNext();
            }
            const b2Vec2 point(huge(), huge());
            switch (random() % 7)
            {
            case 0:
                body->SetLinearVelocity(point);
                break;
            case 1:
                body->SetAngularVelocity(huge());
                break;
            case 2:
                body->ApplyForce(point, b2Vec2(huge(), huge()));
                body->ApplyForce(point, b2Vec2(huge(), huge()));
                break;
            case 3:
                body->ApplyLinearImpulse(point, b2Vec2(huge(), huge()));
                break;
            case 4:
                scene->world.SetGravity(point);
                break;
            case 5:
                body->ApplyTorque(huge());
                break;
            default: {
                b2MassData data;
                data.mass = b2Abs(huge());
                data.I = b2Abs(huge());
                data.center.SetZero();
                body->SetMassData(&data);
                break;
            }
            }
            scene->Step(2);
            ASSERT_EQ(WhyBroken(scene->world, false), "") << "round " << round << ", call " << i;
        }
    }
}

TEST(DynamicsExtremes, KeepTheWorldFiniteWithAnyDensity)
{
    for (const float32 density : {1e-45f, 1e-38f, 1e-30f, 1e-10f, 1e10f, 1e30f, FLT_MAX})
    {
        Scene scene;
        scene.Ground();
        for (int i = 0; i < 3; ++i)
        {
            b2Body* body = scene.Body(b2_dynamicBody, 0.1f * float32(i), 1.0f + float32(i));
            b2PolygonShape shape;
            shape.SetAsBox(0.5f, 0.5f, b2Vec2(0.2f, 0.1f), 0.3f);
            body->CreateFixture(&shape, i == 1 ? density : 1.0f);
        }
        for (int i = 0; i < 60; ++i)
        {
            scene.Step();
            ASSERT_EQ(WhyBroken(scene.world, true), "") << density << ", step " << i;
        }
    }
}

TEST(DynamicsExtremes, KeepTheWorldFiniteWithAnyFriction)
{
    Scene scene;
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, -1.0f);
    Scene::AddBox(ground, 50.0f, 1.0f, FLT_MAX, 0.0f);
    b2Body* box = scene.Body(b2_dynamicBody, 0.0f, 2.0f);
    Scene::AddBox(box, 0.5f, 0.5f, FLT_MAX, 0.0f);
    box->SetLinearVelocity(b2Vec2(5.0f, 0.0f));
    for (int i = 0; i < 120; ++i)
    {
        scene.Step();
        ASSERT_EQ(WhyBroken(scene.world, true), "") << i;
    }
    EXPECT_LT(box->GetPosition().x, 10.0f);
}

TEST(DynamicsExtremes, KeepTheWorldFiniteAtItsFarthestPlaces)
{
    for (const float32 place : {1e6f, 1e10f, 1e15f})
    {
        Scene scene;
        scene.Ground();
        Stack(scene, 0.0f, 2);
        for (int i = 0; i < 4; ++i)
        {
            scene.Ball(i % 2 == 0 ? place : -place, place);
        }
        b2Body* body = scene.Box(0.0f, 5.0f);
        scene.Step(3);
        body->SetTransform(b2Vec2(place, -place), place);
        scene.Step(3);
        EXPECT_EQ(WhyBroken(scene.world, true), "") << place;
        struct Ray : b2RayCastCallback
        {
            float32 ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float32 f) override
            {
                return f;
            }
        } ray;
        scene.world.RayCast(&ray, b2Vec2(-place, -place), b2Vec2(place, place));
        body->SetTransform(b2Vec2(0.0f, 3.0f), 0.0f);
        scene.Step(3);
        EXPECT_EQ(WhyBroken(scene.world, true), "") << place;
    }
}

TEST(DynamicsExtremes, LimitTheLargestVelocityToTheMaxTranslation)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* ball = scene.Ball(0.0f, 0.0f);
    ball->SetLinearVelocity(b2Vec2(FLT_MAX, 0.0f));
    scene.Step();
    EXPECT_NEAR(ball->GetPosition().x, b2_maxTranslation, 1e-4f);
    ball->ApplyLinearImpulse(b2Vec2(-FLT_MAX, 0.0f), b2Vec2(0.0f, FLT_MAX));
    EXPECT_TRUE(ball->GetLinearVelocity().IsValid());
    EXPECT_TRUE(b2IsValid(ball->GetAngularVelocity()));
}

TEST(DynamicsExtremes, ChangeNoVelocityInATinyStep)
{
    for (const float32 step : {1e-45f, 1e-30f, 1e-12f})
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
        b2Body* ball = scene.Ball(5.0f, 0.0f);
        b2DistanceJointDef def;
        def.Initialize(wall, ball, wall->GetPosition(), ball->GetPosition());
        def.frequencyHz = 2.0f;
        scene.world.CreateJoint(&def);
        ball->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
        scene.world.Step(step, 8, 3);
        EXPECT_EQ(ball->GetLinearVelocity(), b2Vec2(1.0f, 0.0f)) << step;
    }
}

// A hit gives the same impulse however short the step, and must not be taken for a lasting force.
TEST(DynamicsExtremes, KeepAChainCalmAfterAHitInAShortStep)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* last = scene.Body(b2_staticBody, 0.0f, 0.0f);
    for (int i = 0; i < 10; ++i)
    {
        b2Body* link = scene.Box(float32(i) + 0.5f, 0.0f, 0.5f, 0.1f);
        b2RevoluteJointDef def;
        def.Initialize(last, link, b2Vec2(float32(i), 0.0f));
        scene.world.CreateJoint(&def);
        last = link;
    }
    last->SetLinearVelocity(b2Vec2(10.0f, 10.0f));
    scene.world.Step(1e-6f, 8, 3);
    for (int i = 0; i < 10; ++i)
    {
        scene.Step();
        for (const b2Body* b = scene.world.GetBodyList(); b; b = b->GetNext())
        {
            ASSERT_LT(b->GetLinearVelocity().Length(), 30.0f) << "step " << i;
        }
    }
}

TEST(DynamicsExtremes, LetAJointRecoverFromNumbersThatWereTooLarge)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* ground = scene.Ground();
    b2Body* arm = scene.Box(1.0f, 5.0f, 1.0f, 0.1f);
    b2RevoluteJointDef def;
    def.Initialize(ground, arm, b2Vec2(0.0f, 5.0f));
    scene.world.CreateJoint(&def);
    b2MassData absurd; // its mass times the speed of its hinge is no float
    absurd.mass = 1e20f;
    absurd.center.Set(0.0f, 1e15f);
    absurd.I = 0.0f;
    arm->SetMassData(&absurd);
    arm->SetAngularVelocity(1e10f);
    scene.Step(3);
    EXPECT_EQ(WhyBroken(scene.world, true), "");
    arm->ResetMassData();
    arm->SetTransform(b2Vec2(1.0f, 5.0f), 0.0f);
    arm->SetLinearVelocity(b2Vec2(0.0f, 1.0f));
    arm->SetAngularVelocity(1.0f);
    scene.Step(60);
    EXPECT_NEAR(arm->GetAngle(), 1.0f, 0.05f);
}

} // namespace
