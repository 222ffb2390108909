// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <vector>

/// The restitution threshold of a world. Steps, sub-steps and impacts have solvers of their own,
/// and each must keep to it.
namespace
{

using namespace dynamics;

class RestitutionThreshold : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, RestitutionThreshold, testing::Values(1, 4));

struct Walls : Scene
{
    explicit Walls(int32 subSteps, float32 threshold) : Scene(b2Vec2_zero)
    {
        world.SetSubStepCount(subSteps);
        world.SetRestitutionThreshold(threshold);
        b2Body* ground = Body(b2_staticBody, 0.0f, -1.0f);
        AddBox(ground, 100.0f, 1.0f, 0.0f, 1.0f);
    }
    /// A ball above the ground that falls on it with constant speed [m/s].
    b2Body* Drop(float32 x, float32 height, float32 speed)
    {
        b2Body* ball = Body(b2_dynamicBody, x, height);
        AddBall(ball, 0.5f, 0.0f, 1.0f);
        ball->SetSleepingAllowed(false);
        ball->SetLinearVelocity(b2Vec2(0.0f, -speed));
        return ball;
    }
};

/// Returns the speed after one impact of each of `count` balls at the given speed, which all must
/// have. Seventeen balls fill one block of sixteen lanes and leave a single contact.
float32 SpeedAfter(int32 subSteps, float32 threshold, float32 speed)
{
    Walls scene(subSteps, threshold);
    std::vector<b2Body*> balls;
    for (int i = 0; i < 17; ++i)
    {
        balls.push_back(scene.Drop(2.0f * float32(i), 0.6f, speed));
    }
    scene.Step(int(0.2f / speed / kStep) + 3);
    for (const b2Body* ball : balls)
    {
        EXPECT_EQ(ball->GetLinearVelocity().y, balls[0]->GetLinearVelocity().y);
    }
    return balls[0]->GetLinearVelocity().y;
}

TEST_P(RestitutionThreshold, IsTheConstantUnlessSet)
{
    const b2World world(b2Vec2_zero);
    EXPECT_EQ(world.GetRestitutionThreshold(), b2_velocityThreshold);
    EXPECT_NEAR(SpeedAfter(GetParam(), b2_velocityThreshold, 0.95f), 0.0f, 1e-4f);
    EXPECT_NEAR(SpeedAfter(GetParam(), b2_velocityThreshold, 1.05f), 1.05f, 1e-4f);
}

TEST_P(RestitutionThreshold, DecidesWhetherABallBounces)
{
    for (const float32 threshold : {0.25f, 3.0f})
    {
        SCOPED_TRACE(threshold);
        const float32 below = 0.95f * threshold;
        const float32 above = 1.05f * threshold;
        EXPECT_NEAR(SpeedAfter(GetParam(), threshold, below), 0.0f, 1e-4f);
        EXPECT_NEAR(SpeedAfter(GetParam(), threshold, above), above, 1e-4f);
    }
    EXPECT_NEAR(SpeedAfter(GetParam(), 0.0f, 0.05f), 0.05f, 1e-4f);
}

TEST_P(RestitutionThreshold, DecidesWhetherABulletBounces)
{
    for (const float32 threshold : {90.0f, 110.0f})
    {
        SCOPED_TRACE(threshold);
        Walls scene(GetParam(), threshold);
        b2Body* bullet = scene.Drop(0.0f, 5.0f, 100.0f);
        bullet->SetBullet(true);
        scene.Step(6);
        const float32 expected = threshold < 100.0f ? 100.0f : 0.0f;
        EXPECT_NEAR(bullet->GetLinearVelocity().y, expected, 1e-3f);
    }
}

TEST_P(RestitutionThreshold, IsKeptInSnapshots)
{
    Walls scene(GetParam(), 3.0f);
    (void)scene.Drop(0.0f, 0.6f, 2.0f);
    b2World restored(b2Vec2_zero);
    ASSERT_EQ(b2RestoreSnapshot(restored, b2SaveSnapshot(scene.world)), nullptr);
    EXPECT_EQ(restored.GetRestitutionThreshold(), 3.0f);
    for (int i = 0; i < 12; ++i)
    {
        restored.Step(kStep, 8, 3);
    }
    EXPECT_NEAR(restored.GetBodyList()->GetLinearVelocity().y, 0.0f, 1e-4f);
}

} // namespace
