// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <vector>

/// Contacts that come near fast in a step of sub-steps bounce before its first kick.
namespace
{

using namespace dynamics;

struct Bounce : Scene
{
    explicit Bounce(int32 subSteps) : Scene(b2Vec2_zero)
    {
        world.SetSubStepCount(subSteps);
        world.SetContinuousPhysics(false);
    }
    /// A frictionless ball of 1 kg that bounces with the given restitution.
    b2Body* Add(float32 x, float32 speed, float32 restitution)
    {
        b2Body* body = Body(b2_dynamicBody, x, 0.0f);
        AddBall(body, 0.5f, 0.0f, restitution)->SetDensity(4.0f / b2_pi);
        body->ResetMassData();
        body->SetSleepingAllowed(false);
        body->SetLinearVelocity(b2Vec2(speed, 0.0f));
        balls.push_back(body);
        return body;
    }

    std::vector<b2Body*> balls;
};

class Bouncer : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, Bouncer, testing::Values(2, 4, 8));

TEST_P(Bouncer, PassesASpeedThroughARowOfTouchingBalls)
{
    Bounce row(GetParam());
    row.Add(-1.03f, 4.0f, 1.0f);
    for (int i = 0; i < 4; ++i)
    {
        row.Add(float32(i), 0.0f, 1.0f);
    }
    row.Step(5);
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_NEAR(row.balls[std::size_t(i)]->GetLinearVelocity().x, 0.0f, 1e-3f) << i;
    }
    EXPECT_NEAR(row.balls[4]->GetLinearVelocity().x, 4.0f, 1e-3f);
}

TEST_P(Bouncer, KeepsTheSpeedRatioOfTheRestitution)
{
    for (const float32 restitution : {1.0f, 0.5f, 0.25f})
    {
        Bounce scene(GetParam());
        Scene::AddBox(scene.Body(b2_staticBody, 1.0f, 0.0f), 0.5f, 10.0f, 0.0f, 0.0f);
        b2Body* ball = scene.Add(-1.0f, 10.0f, restitution);
        scene.Step(30);
        EXPECT_NEAR(ball->GetLinearVelocity().x, -10.0f * restitution, 1e-3f) << restitution;
    }
}

TEST_P(Bouncer, KeepsEnergyWhenACornerHitsAWall)
{
    for (int i = 1; i < 16; ++i)
    {
        Bounce scene(GetParam());
        b2Body* wall = scene.Body(b2_staticBody, 1.0f, 0.0f);
        Scene::AddBox(wall, 0.5f, 10.0f, 0.0f, 1.0f);
        b2Body* box = scene.Body(b2_dynamicBody, -1.0f, 0.0f, 0.1f * float32(i));
        Scene::AddBox(box, 0.5f, 0.25f, 0.0f, 1.0f);
        box->SetLinearVelocity(b2Vec2(10.0f, 1.0f));
        box->SetAngularVelocity(-8.0f + float32(i));
        const auto energy = [&] {
            return box->GetMass() * box->GetLinearVelocity().LengthSquared() +
                   box->GetInertia() * box->GetAngularVelocity() * box->GetAngularVelocity();
        };
        const float32 before = energy();
        scene.Step(20);
        EXPECT_LT(box->GetLinearVelocity().x, 0.0f) << i;
        EXPECT_NEAR(energy() / before, 1.0f, 1e-4f) << i;
    }
}

} // namespace
