// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"
#include "UnguardedWorld.h"

#include <gtest/gtest.h>

#include <algorithm>

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

/// A tree of 31 posts in five levels, which hangs from a ceiling.
struct HangingTree : Scene
{
    HangingTree()
    {
        const b2Vec2 top(0.0f, 20.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(Body(b2_staticBody, top.x, top.y), HangTree(world, top, 4, 3.0f), top);
        world.CreateJoint(&hinge);
    }
};

/// Under load its joints open by 0.8 m and close again over 10 s: what that lifts is not won.
TEST(EnergyGuardSwing, LetsATreeOfHingesSwingWhileItsJointsClose)
{
    HangingTree scene;
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

/// Each step is taken with the guard and without it. The guard acts near turning points, where the
/// tree has little energy. It takes at most 2.0 % of the largest kinetic energy of late in a step,
/// and 65 % of the present one. Once it took all of it in step 440.
TEST(EnergyGuardSwing, TakesNoEnergyInAJerk)
{
    constexpr double kFade = 0.1 / 60.0; // of the largest kinetic energy, as the guard forgets it
    HangingTree scene;
    b2World unguarded(b2Vec2_zero);
    double largest = 0.0;
    double taken = 0.0;
    for (int32 step = 0; step < 1200; ++step)
    {
        ASSERT_EQ(b2RestoreSnapshot(unguarded, b2SaveSnapshot(scene.world)), nullptr);
        LeaveNextStepUnguarded(unguarded);
        largest = std::max((1.0 - kFade) * largest, KineticOf(scene.world));
        scene.Step();
        unguarded.Step(kStep, 8, 3);
        const double without = KineticOf(unguarded);
        const double left = KineticOf(scene.world);
        EXPECT_LE(without - left, 0.03 * largest + 1e-9) << "step " << step;
        EXPECT_GE(left, 0.2 * without) << "step " << step;
        taken += without - left;
    }
    EXPECT_GT(taken, 0.0) << "what a guard that does nothing takes is no measure";
}

/// With sub-steps the hinges of the tree are solved directly, so there is nothing to take.
TEST(EnergyGuardSwing, TakesNothingFromATreeInSubSteps)
{
    for (const int32 subSteps : {2, 4})
    {
        HangingTree guarded;
        HangingTree unguarded;
        guarded.world.SetSubStepCount(subSteps);
        unguarded.world.SetSubStepCount(subSteps);
        for (int32 step = 0; step < 600; ++step)
        {
            LeaveNextStepUnguarded(unguarded.world);
            guarded.Step();
            unguarded.Step();
            ASSERT_EQ(KineticOf(guarded.world), KineticOf(unguarded.world))
                << subSteps << " sub-steps, step " << step;
        }
    }
}

} // namespace
