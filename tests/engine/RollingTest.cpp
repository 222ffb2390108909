// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>

/// Contacts whose normals and levers turn within a step.
namespace
{

using namespace dynamics;

/// A ball with a weight off its centre that rocks on a flat edge.
struct RockingBall : Scene
{
    RockingBall(int32 subSteps, float32 friction)
    {
        world.SetSubStepCount(subSteps);
        b2EdgeShape ground;
        ground.Set(b2Vec2(-500.0f, 0.0f), b2Vec2(500.0f, 0.0f));
        Add(Body(b2_staticBody, 0.0f, 0.0f), ground, friction, 0.0f);
        ball = Body(b2_dynamicBody, 0.0f, 1.0f, 1.0f);
        AddBall(ball, 1.0f, friction);
        b2CircleShape weight;
        weight.m_radius = 0.3f;
        weight.m_p.Set(0.0f, -0.6f);
        ball->CreateFixture(&weight, 20.0f);
    }

    double Energy() const // [J], from the lowest place on
    {
        const double mass = ball->GetMass();
        const double offset = ball->GetLocalCenter().Length();
        const double inertia = ball->GetInertia() - mass * offset * offset;
        const double speed = ball->GetAngularVelocity();
        const double height = double(ball->GetWorldCenter().y) - 1.0 + offset;
        return 0.5 * mass * double(ball->GetLinearVelocity().LengthSquared()) +
               0.5 * inertia * speed * speed - double(world.GetGravity().y) * mass * height;
    }

    b2Body* ball;
};

/// With normals and levers from the start of the step it went up to 44 J, with any number.
TEST(Rolling, GainsNoEnergyWhereAWeightRocksABall)
{
    for (const int32 subSteps : {1, 2, 4, 8, 16})
    {
        for (const float32 friction : {0.0f, 1.0f})
        {
            RockingBall scene(subSteps, friction);
            const double first = scene.Energy();
            double most = 0.0;
            for (int i = 0; i < 1200; ++i)
            {
                scene.Step();
                most = std::max(most, scene.Energy());
            }
            EXPECT_LT(most, 1.07 * first) << subSteps << " sub-steps, friction " << friction;
            EXPECT_GT(scene.Energy(), 0.6 * first) << subSteps << ", friction " << friction;
        }
    }
}

} // namespace
