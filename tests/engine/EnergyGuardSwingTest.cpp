// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

/// Whole worlds that the energy guard must leave in motion.
namespace
{

using namespace dynamics;

/// Hangs a tree of posts, each with two others half as far apart below it.
b2Body* HangTree(b2World& world, const b2Vec2& top, int32 levels, float32 reach)
{
    constexpr float32 kHalf = 0.5f; // [m]
    b2BodyDef at;
    at.type = b2_dynamicBody;
    at.position = top - b2Vec2(0.0f, kHalf);
    b2Body* post = world.CreateBody(&at);
    Scene::AddBox(post, 0.25f * kHalf, kHalf)->SetDensity(20.0f);
    post->ResetMassData();
    for (const float32 x : {-reach, reach})
    {
        if (levels > 0)
        {
            const b2Vec2 end = top + b2Vec2(x, -2.0f * kHalf);
            b2RevoluteJointDef hinge;
            hinge.Initialize(post, HangTree(world, end, levels - 1, 0.5f * reach), end);
            world.CreateJoint(&hinge);
        }
    }
    return post;
}

/// Under load its joints open by 0.8 m and close again over 10 s: what that lifts is not won.
TEST(EnergyGuardSwing, LetsATreeOfHingesSwingWhileItsJointsClose)
{
    Scene scene;
    b2Body* ceiling = scene.Body(b2_staticBody, 0.0f, 20.0f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(ceiling, HangTree(scene.world, b2Vec2(0.0f, 20.0f), 4, 3.0f),
                     b2Vec2(0.0f, 20.0f));
    scene.world.CreateJoint(&hinge);
    for (int32 second = 0; second < 15; ++second)
    {
        float32 fastest = 0.0f;
        for (int32 step = 0; step < 60; ++step)
        {
            scene.world.Step(kStep, 8, 3);
            for (const b2Body* body = scene.world.GetBodyList(); body; body = body->GetNext())
            {
                fastest = b2Max(fastest, body->GetLinearVelocity().Length());
            }
        }
        EXPECT_GT(fastest, 0.2f) << second << " s";
    }
}

} // namespace
