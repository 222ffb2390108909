// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

/// Boxes between walls that leave no room for their skins.
namespace
{

using namespace dynamics;

class TightFit : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, TightFit, testing::Values(2, 4, 8));

/// A pit of edges on a kinematic body.
b2Body* Pit(Scene& scene, float32 half, const b2Vec2& velocity)
{
    b2Body* const pit = scene.Body(b2_kinematicBody, 0.0f, 0.0f);
    pit->SetLinearVelocity(velocity);
    const b2Vec2 corners[] = {b2Vec2(-half, 3.0f), b2Vec2(-half, 0.0f), b2Vec2(half, 0.0f),
                              b2Vec2(half, 3.0f)};
    for (int i = 0; i < 3; ++i)
    {
        b2EdgeShape edge;
        edge.Set(corners[i], corners[i + 1]);
        Scene::Add(pit, edge, 0.5f, 0.0f);
    }
    return pit;
}

float32 LargestImpulse(const b2World& world)
{
    float32 largest = 0.0f;
    for (const b2Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext())
    {
        for (int32 i = 0; i < c->GetManifold()->pointCount; ++i)
        {
            largest = std::max(largest, c->GetManifold()->points[i].normalImpulse);
        }
    }
    return largest;
}

TEST_P(TightFit, RestsInAMovingPit)
{
    for (const int count : {1, 3, 4, 5})
    {
        for (const float32 slack : {0.0f, 0.01f, 0.02f})
        {
            for (const float32 speed : {0.0f, 5.0f, 40.0f, 100.0f})
            {
                SCOPED_TRACE(testing::Message()
                             << count << " boxes, slack " << slack << " m, " << speed << " m/s");
                Scene scene;
                scene.world.SetSubStepCount(GetParam());
                scene.world.SetContinuousPhysics(speed != 40.0f);
                const b2Vec2 velocity(speed, 0.0f);
                const float32 half = 0.5f * (float32(count) + slack);
                b2Body* const pit = Pit(scene, half, velocity);
                std::vector<b2Body*> boxes;
                for (int i = 0; i < count; ++i)
                {
                    boxes.push_back(scene.Box(-0.5f * float32(count) + 0.5f + float32(i), 0.5f));
                    boxes.back()->SetLinearVelocity(velocity);
                }
                const float32 weight = boxes.front()->GetMass() * 10.0f * kStep;
                for (int step = 0; step < 300; ++step)
                {
                    scene.Step();
                    EXPECT_LT(LargestImpulse(scene.world), 10.0f * float32(count) * weight);
                }
                for (int i = 0; i < count; ++i)
                {
                    const b2Vec2 offset = boxes[std::size_t(i)]->GetPosition() - pit->GetPosition();
                    EXPECT_NEAR(offset.x, -0.5f * float32(count) + 0.5f + float32(i), 0.02f);
                    EXPECT_NEAR(offset.y, 0.5f, 0.02f);
                }
            }
        }
    }
}

TEST_P(TightFit, StaysStillBetweenTwoWalls)
{
    for (const float32 room : {-0.02f, 0.0f, 0.01f, 0.02f})
    {
        Scene scene(b2Vec2_zero);
        scene.world.SetSubStepCount(GetParam());
        b2Body* const walls = scene.Body(b2_staticBody, 0.0f, 0.0f);
        for (const float32 x : {-0.5f * (1.0f + room), 0.5f * (1.0f + room)})
        {
            b2EdgeShape edge;
            edge.Set(b2Vec2(x, -3.0f), b2Vec2(x, 3.0f));
            Scene::Add(walls, edge, 0.2f, 0.0f);
        }
        b2Body* const box = scene.Box(0.0f, 0.0f);
        box->SetSleepingAllowed(false);
        float32 farthest = 0.0f;
        for (int step = 0; step < 600; ++step)
        {
            scene.Step();
            farthest = std::max(farthest, b2Abs(box->GetPosition().x));
        }
        EXPECT_LT(farthest, 0.005f) << "room " << room << " m";
    }
}

} // namespace
