// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

/// A small stack is solved directly, so a load that comes suddenly reaches the ground in the same
/// step. Iterations move it on by one contact each.
namespace
{

using namespace dynamics;

class ContactSystem : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, ContactSystem, testing::Values(2, 4, 8));

TEST_P(ContactSystem, HoldsASuddenLoadOfAThousandTimesTheWeight)
{
    Scene scene;
    scene.world.SetSubStepCount(GetParam());
    scene.Ground();
    std::vector<b2Body*> boxes;
    for (int i = 0; i < 8; ++i)
    {
        boxes.push_back(scene.Box(0.0f, 0.5f + float32(i)));
    }
    scene.Step(30);
    const float32 height = boxes.back()->GetPosition().y;
    for (int i = 0; i < 60; ++i)
    {
        boxes.back()->ApplyForceToCenter(b2Vec2(0.0f, -10000.0f), true);
        scene.Step();
        for (const b2Body* box : boxes)
        {
            ASSERT_LT(box->GetLinearVelocity().Length(), 0.001f) << "step " << i; // [m/s]
        }
    }
    EXPECT_NEAR(boxes.back()->GetPosition().y, height, 0.001f);
}

/// A platform pushes a row of boxes into a wall. Impulses of the impacts must not act once more in
/// the next sub-step: the boxes would leave the platform far faster than it moves.
TEST_P(ContactSystem, PushesNoBoxFasterThanThePlatform)
{
    for (const float32 speed : {5.0f, 20.0f}) // [m/s]
    {
        constexpr int kCount = 14;
        constexpr float32 kFriction = 0.6f;
        Scene scene;
        scene.world.SetSubStepCount(GetParam());
        b2EdgeShape ground;
        ground.Set(b2Vec2(-50.0f, 0.0f), b2Vec2(200.0f, 0.0f));
        b2Body* fixed = scene.Body(b2_staticBody, 0.0f, 0.0f);
        Scene::Add(fixed, ground, kFriction, 0.0f);
        b2PolygonShape wall;
        wall.SetAsBox(0.5f, 1.0f, b2Vec2(1.2f * float32(kCount) + 12.0f, 1.0f), 0.0f);
        std::vector<b2Body*> boxes;
        for (int i = 0; i < kCount; ++i)
        {
            boxes.push_back(scene.Body(b2_dynamicBody, 2.0f + 1.2f * float32(i), 0.5f));
            Scene::AddBox(boxes.back(), 0.5f, 0.5f, kFriction);
        }
        b2Body* platform = scene.Body(b2_kinematicBody, 0.0f, 0.6f);
        Scene::AddBox(platform, 0.5f, 0.55f, kFriction);
        platform->SetLinearVelocity(b2Vec2(speed, 0.0f));
        Scene::Add(fixed, wall, kFriction, 0.0f);
        for (int i = 0; i < 300; ++i)
        {
            if (platform->GetPosition().x > float32(kCount) + 6.0f)
            {
                platform->SetLinearVelocity(b2Vec2_zero);
            }
            scene.Step();
            for (const b2Body* box : boxes)
            {
                ASSERT_LT(box->GetLinearVelocity().Length(), 1.1f * speed) << "step " << i;
            }
        }
        EXPECT_GT(boxes.front()->GetPosition().x, 10.0f); // pushed
    }
}

} // namespace
