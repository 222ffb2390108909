// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

/// Stacks that are put together at rest have their load from the first sub-step on. They have more
/// contacts than are solved exactly, so iterations alone would need seconds to find it.
namespace
{

using namespace dynamics;

constexpr int kBase = 20;

struct Pyramid : Scene
{
    explicit Pyramid(int32 subSteps)
    {
        world.SetSubStepCount(subSteps);
        AddBox(Body(b2_staticBody, 0.0f, -1.0f), 100.0f, 1.0f, 0.6f);
        for (int row = 0; row < kBase; ++row)
        {
            for (int i = 0; i < kBase - row; ++i)
            {
                boxes.push_back(Body(b2_dynamicBody, float32(i) - 0.5f * float32(kBase - row - 1),
                                     0.5f + float32(row)));
                AddBox(boxes.back(), 0.5f, 0.5f, 0.6f);
            }
        }
    }

    float32 Fastest() const
    {
        float32 fastest = 0.0f;
        for (const b2Body* box : boxes)
        {
            fastest = std::max(fastest, box->GetLinearVelocity().Length());
        }
        return fastest;
    }

    /// Returns the load of the ground as a fraction of the pyramid's weight.
    float32 ShareOnTheGround() const
    {
        float32 impulse = 0.0f;
        for (const b2Contact* c = world.GetContactList(); c; c = c->GetNext())
        {
            const bool isOnGround = c->GetFixtureA()->GetBody()->GetType() == b2_staticBody ||
                                    c->GetFixtureB()->GetBody()->GetType() == b2_staticBody;
            for (int32 i = 0; isOnGround && i < c->GetManifold()->pointCount; ++i)
            {
                impulse += c->GetManifold()->points[i].normalImpulse;
            }
        }
        return impulse / (float32(boxes.size()) * 10.0f * kStep);
    }

    std::vector<b2Body*> boxes;
};

class FirstLoads : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, FirstLoads, testing::Values(2, 4, 8));

TEST_P(FirstLoads, HoldANewPyramidFromTheFirstStep)
{
    Pyramid pyramid(GetParam());
    pyramid.Step();
    EXPECT_LT(pyramid.Fastest(), 0.01f); // [m/s]
    EXPECT_NEAR(pyramid.ShareOnTheGround(), 1.0f, 0.01f);
}

TEST_P(FirstLoads, LetANewPyramidSleepWithinASecond)
{
    Pyramid pyramid(GetParam());
    pyramid.Step(60);
    EXPECT_TRUE(AllAwake(pyramid.boxes, false));
}

} // namespace
