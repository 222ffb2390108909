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

} // namespace
