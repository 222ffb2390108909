// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <gtest/gtest.h>

/// The section about sensors.
namespace
{

using dynamics::Scene;

struct Counter : public b2ContactListener
{
    void BeginContact(b2Contact*) override { ++begun; }
    void EndContact(b2Contact*) override { ++ended; }
    void PreSolve(b2Contact*, const b2Manifold*) override { ++solved; }
    int begun = 0;
    int ended = 0;
    int solved = 0;
};

/// A ball that falls through the zone of a sensor on a body of this type.
void FallThrough(b2BodyType zoneType)
{
    Counter counter;
    Scene scene;
    scene.world.SetContactListener(&counter);
    b2Body* zone = scene.Body(zoneType, 0.0f, 0.0f);
    zone->SetGravityScale(0.0f);
    Scene::AddBox(zone, 2.0f, 1.0f)->SetSensor(true);
    b2Body* ball = scene.Ball(0.0f, 3.0f);
    bool touched = false;
    for (int i = 0; i < 120; ++i)
    {
        scene.Step();
        for (b2Contact* c = scene.world.GetContactList(); c; c = c->GetNext())
        {
            EXPECT_EQ(c->GetManifold()->pointCount, 0);
            touched = touched || c->IsTouching();
        }
    }
    EXPECT_TRUE(touched);
    EXPECT_EQ(counter.begun, 1);
    EXPECT_EQ(counter.ended, 1);
    EXPECT_EQ(counter.solved, 0);
    EXPECT_NEAR(ball->GetLinearVelocity().y, -20.0f, 1e-3f);
    EXPECT_EQ(zone->GetPosition(), b2Vec2_zero);
    scene.world.SetContactListener(nullptr);
}

TEST(Sensors, DetectWithoutResponseOnBodiesOfEveryType)
{
    FallThrough(b2_staticBody);
    FallThrough(b2_kinematicBody);
    FallThrough(b2_dynamicBody);
}

TEST(Sensors, MixWithSolidFixturesOnOneBody)
{
    Counter counter;
    Scene scene;
    scene.world.SetContactListener(&counter);
    b2Body* ground = scene.Ground();
    b2Fixture* zone = Scene::AddBox(ground, 3.0f, 3.0f);
    zone->SetSensor(true);
    b2Body* ball = scene.Ball(0.0f, 5.0f);
    scene.Step(180);
    EXPECT_EQ(counter.begun, 2);
    EXPECT_GT(ball->GetPosition().y, 0.45f);
    scene.world.SetContactListener(nullptr);
}

TEST(Sensors, NeedADynamicBodyForAContact)
{
    for (const b2BodyType typeA : {b2_staticBody, b2_kinematicBody})
    {
        for (const b2BodyType typeB : {b2_staticBody, b2_kinematicBody})
        {
            Scene scene;
            Scene::AddBox(scene.Body(typeA, 0.0f, 0.0f), 1.0f, 1.0f)->SetSensor(true);
            Scene::AddBox(scene.Body(typeB, 0.5f, 0.0f), 1.0f, 1.0f);
            scene.Step();
            EXPECT_EQ(scene.world.GetContactCount(), 0) << typeA << " " << typeB;
        }
    }
}

} // namespace
