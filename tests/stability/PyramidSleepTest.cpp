// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cstdio>

/// When pyramids sleep that were put together without room for their skins. Prints a line for each.
namespace
{

using namespace dynamics;

constexpr int kSteps = 300; // 5 s

struct Verdict
{
    float32 slept = -1.0f;   ///< when all slept [s]; -1: not within 5 s
    float32 fastest = 0.0f;  ///< of any box, at the end [m/s]
    float32 sideways = 0.0f; ///< the farthest way of any box, at the end [m]
};

Verdict Watch(int base, int32 subSteps)
{
    Scene scene;
    scene.world.SetSubStepCount(subSteps);
    scene.AddBox(scene.Body(b2_staticBody, 0.0f, -1.0f), 100.0f, 1.0f); // the ground
    std::vector<b2Body*> boxes;
    std::vector<float32> places;
    for (int row = 0; row < base; ++row)
    {
        for (int i = 0; i < base - row; ++i)
        {
            places.push_back(float32(i) - 0.5f * float32(base - row - 1));
            boxes.push_back(scene.Box(places.back(), 0.5f + float32(row)));
            boxes.back()->GetFixtureList()->SetFriction(0.6f);
        }
    }
    Verdict verdict;
    for (int step = 1; step <= kSteps && verdict.slept < 0.0f; ++step)
    {
        scene.Step(1);
        bool awake = false;
        for (const b2Body* box : boxes)
        {
            awake = awake || box->IsAwake();
        }
        verdict.slept = awake ? -1.0f : float32(step) / 60.0f;
    }
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        verdict.fastest = b2Max(verdict.fastest, boxes[i]->GetLinearVelocity().Length());
        verdict.sideways = b2Max(verdict.sideways, b2Abs(boxes[i]->GetPosition().x - places[i]));
    }
    std::printf("pyramid of base %3d, %2d sub-steps: sleeps after %5.2f s, speed %.4f m/s, "
                "sideways %.3f m\n",
                base, int(subSteps), double(verdict.slept), double(verdict.fastest),
                double(verdict.sideways));
    return verdict;
}

TEST(PyramidSleep, ComesWithinFiveSeconds)
{
    for (const int32 subSteps : {2, 4, 8, 16})
    {
        for (const int base : {5, 10, 20, 30, 100})
        {
            const Verdict verdict = Watch(base, subSteps);
            EXPECT_GT(verdict.slept, 0.0f) << base << ", " << subSteps;
            EXPECT_LT(verdict.sideways, 0.1f) << base << ", " << subSteps;
        }
    }
}

// By the manual's scheme sweeps find its load too slowly: it swings up and down, and has to stand
// and stay awake.
TEST(PyramidSleep, DoesNotComeToABaseOfAHundredWhileItSwings)
{
    const Verdict verdict = Watch(100, 1);
    EXPECT_LT(verdict.fastest, 3.0f);
    EXPECT_LT(verdict.sideways, 1.0f);
    EXPECT_TRUE(verdict.slept < 0.0f || verdict.fastest == 0.0f);
}

} // namespace
