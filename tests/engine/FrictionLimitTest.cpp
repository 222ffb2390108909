// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

/// What the impact of the pusher took was given again in each kick of the step, and shot the boxes
/// away at 15 m/s.
TEST(Friction, LeavesARowOfBoxesAtTheSpeedOfItsPusher)
{
    for (const int32 subSteps : {2, 4, 8, 16})
    {
        for (const float32 pitch : {1.0f, 1.015f, 1.03f})
        {
            for (const float32 speed : {0.2f, 1.0f, 5.0f})
            {
                Scene scene;
                scene.world.SetSubStepCount(subSteps);
                Scene::AddBox(scene.Body(b2_staticBody, 0.0f, -0.5f), 100.0f, 0.5f, 0.5f);
                b2Body* pusher = scene.Body(b2_kinematicBody, -0.52f, 1.0f);
                Scene::AddBox(pusher, 0.5f, 1.0f, 0.5f);
                pusher->SetLinearVelocity(b2Vec2(speed, 0.0f));
                std::vector<b2Body*> boxes;
                for (int32 i = 0; i < 8; ++i)
                {
                    boxes.push_back(scene.Body(b2_dynamicBody, 1.0f + pitch * float32(i), 0.5f));
                    Scene::AddBox(boxes.back(), 0.5f, 0.5f, 0.5f);
                    boxes.back()->GetFixtureList()->SetDensity(i % 2 == 0 ? 1.0f : 4.0f);
                    boxes.back()->ResetMassData();
                }
                float32 fastest = 0.0f;
                for (int32 i = 0; i < 90; ++i)
                {
                    scene.Step();
                    for (const b2Body* box : boxes)
                    {
                        fastest = b2Max(fastest, box->GetLinearVelocity().Length());
                    }
                }
                EXPECT_LT(fastest, 1.1f * speed) << subSteps << ", " << pitch << ", " << speed;
            }
        }
    }
}

} // namespace
