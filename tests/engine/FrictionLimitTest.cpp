// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>

/// The friction of a step is at most its normal force times the coefficient.
namespace
{

using namespace dynamics;

struct FrictionSum : b2ContactListener
{
    void PostSolve(b2Contact*, const b2ContactImpulse* impulse) override
    {
        for (int32 i = 0; i < impulse->count; ++i)
        {
            normal += impulse->normalImpulses[i];
            tangent += b2Abs(impulse->tangentImpulses[i]);
        }
    }
    float32 normal = 0.0f, tangent = 0.0f;
};

/// The normal of a disc that slides in a ring turns all the time.
TEST(Friction, StaysWithinItsLimitOnACurve)
{
    for (const int32 subSteps : {1, 2, 4, 8, 16})
    {
        Scene scene(b2Vec2_zero);
        scene.world.SetSubStepCount(subSteps);
        FrictionSum sum;
        scene.world.SetContactListener(&sum);
        b2Vec2 corners[360];
        for (int i = 0; i < 360; ++i)
        {
            corners[i] = 10.0f * b2Vec2(std::cos(float32(i) * b2_pi / 180.0f),
                                        std::sin(float32(i) * b2_pi / 180.0f));
        }
        b2ChainShape ring;
        ring.CreateLoop(corners, 360);
        Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), ring, 0.2f, 0.0f);
        b2Body* const disc = scene.Ball(0.0f, -9.5f, 0.5f);
        disc->SetFixedRotation(true);
        disc->GetFixtureList()->SetFriction(0.2f);
        disc->SetLinearVelocity(b2Vec2(10.0f, 0.0f));
        scene.Step(120);
        EXPECT_LT(sum.tangent, 0.201f * sum.normal) << subSteps;
        EXPECT_NEAR(disc->GetLinearVelocity().Length(), 7.037f, 0.15f) << subSteps;
        scene.world.SetContactListener(nullptr);
    }
}

} // namespace
