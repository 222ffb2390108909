// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

// Declared as in programs of the 2.3 generation, without a header of the engine.
extern int32 b2_gjkCalls, b2_gjkIters, b2_gjkMaxIters;
extern int32 b2_toiCalls, b2_toiIters, b2_toiMaxIters;
extern int32 b2_toiRootIters, b2_toiMaxRootIters;
extern float32 b2_toiTime, b2_toiMaxTime;

/// The statistics of searches for distances and impacts.
namespace
{

using namespace dynamics;

void Reset()
{
    b2_gjkCalls = b2_gjkIters = b2_gjkMaxIters = 0;
    b2_toiCalls = b2_toiIters = b2_toiMaxIters = b2_toiRootIters = b2_toiMaxRootIters = 0;
    b2_toiTime = b2_toiMaxTime = 0.0f;
}

std::array<int32, 8> Counts()
{
    return {b2_gjkCalls, b2_gjkIters,    b2_gjkMaxIters,  b2_toiCalls,
            b2_toiIters, b2_toiMaxIters, b2_toiRootIters, b2_toiMaxRootIters};
}

/// Boxes as bullets, fast enough to cross a wall in a step.
class Volley
{
public:
    explicit Volley(int32 threads = 1, int count = 100) : m_scene(b2Vec2(0.0f, 0.0f))
    {
        m_scene.world.SetThreadCount(threads);
        Scene::AddBox(m_scene.Body(b2_staticBody, 4.0f, 0.0f), 0.01f, 100.0f);
        for (int i = 0; i < count; ++i)
        {
            b2Body* box = m_scene.Box(3.0f, 1.5f * float32(i) - 70.0f, 0.1f, 0.1f);
            box->SetBullet(true);
            box->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
            box->SetAngularVelocity(5.0f);
        }
    }
    void Step(int count = 1) { m_scene.Step(count); }
    b2World& World() { return m_scene.world; }

private:
    Scene m_scene;
};

TEST(SearchCounts, CountCallsOfDistance)
{
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    b2DistanceInput input;
    input.proxyA.Set(&box, 0);
    input.proxyB.Set(&box, 0);
    input.transformB.p.Set(3.0f, 2.5f);
    Reset();
    int32 iterations = 0;
    int32 longest = 0;
    for (int32 i = 1; i <= 3; ++i)
    {
        b2SimplexCache cache;
        b2DistanceOutput output;
        input.transformB.q.Set(0.3f * float32(i));
        b2Distance(&output, &cache, &input);
        iterations += output.iterations;
        longest = b2Max(longest, output.iterations);
        EXPECT_EQ(b2_gjkCalls, i);
    }
    EXPECT_GT(iterations, 0);
    EXPECT_EQ(b2_gjkIters, iterations);
    EXPECT_EQ(b2_gjkMaxIters, longest);
    EXPECT_EQ(b2_toiCalls, 0);
}

TEST(SearchCounts, CountCallsOfTimeOfImpact)
{
    b2PolygonShape box;
    box.SetAsBox(1.0f, 0.1f);
    b2TOIInput input;
    input.proxyA.Set(&box, 0);
    input.proxyB.Set(&box, 0);
    input.sweepB.c0.Set(0.0f, 5.0f);
    input.sweepB.c.Set(0.0f, -5.0f);
    input.sweepB.a = 3.0f; // turning takes more than one advance
    Reset();
    b2TOIOutput output;
    for (int32 i = 1; i <= 20; ++i)
    {
        b2TimeOfImpact(&output, &input);
        ASSERT_EQ(output.state, b2TOIOutput::e_touching);
        ASSERT_EQ(b2_toiCalls, i);
    }
    EXPECT_GT(b2_toiMaxIters, 1);
    EXPECT_EQ(b2_toiIters, 20 * b2_toiMaxIters) << "the same search each time";
    EXPECT_EQ(b2_gjkCalls, b2_toiIters) << "one distance an advance";
    EXPECT_GE(b2_toiRootIters, b2_toiIters - 20) << "the last advance finds the touch";
    EXPECT_GE(b2_toiMaxRootIters, 1);
    EXPECT_LE(b2_toiMaxRootIters, b2_toiRootIters);
    EXPECT_GT(b2_toiTime, 0.0f);
    EXPECT_GT(b2_toiMaxTime, 0.0f);
    EXPECT_LT(b2_toiMaxTime, b2_toiTime);
}

TEST(SearchCounts, CountImpactsOfAStep)
{
    Volley volley;
    Reset();
    volley.Step();
    EXPECT_GE(b2_toiCalls, 100);
    EXPECT_GE(b2_toiIters, b2_toiCalls);
    EXPECT_EQ(b2_gjkCalls, b2_toiIters);
    EXPECT_EQ(b2_toiTime, 0.0f) << "no clock is read unless the world is profiled";
    Volley profiled;
    profiled.World().GetProfile();
    profiled.Step();
    EXPECT_GT(b2_toiTime, 0.0f);
}

TEST(SearchCounts, CountACircleWithoutIterations)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Scene::AddBall(scene.Body(b2_staticBody, 1.5f, 0.0f), 0.1f);
    b2Body* ball = scene.Ball(0.0f, 0.0f, 0.1f);
    ball->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    Reset();
    scene.Step();
    EXPECT_GE(b2_toiCalls, 1);
    EXPECT_EQ(b2_toiIters, 0);
}

TEST(SearchCounts, StayZeroForStacksAtRest)
{
    Scene scene;
    scene.Ground();
    Stack(scene, 0.0f, 3);
    scene.Step(10);
    Reset();
    scene.Step(10);
    EXPECT_EQ(Counts(), (std::array<int32, 8>{}));
}

TEST(SearchCounts, AreTheSameWithAnyNumberOfThreads)
{
    Reset();
    Volley(1).Step(3);
    const auto alone = Counts();
    for (const int32 threads : {2, 4})
    {
        Reset();
        Volley(threads).Step(3);
        EXPECT_EQ(Counts(), alone) << threads;
    }
}

// The thread sanitizer looks at it.
TEST(SearchCounts, HaveNoRaceBetweenWorldsInThreads)
{
    Reset();
    std::thread other([] { Volley(1, 10).Step(20); });
    Volley(2, 10).Step(20);
    other.join();
    EXPECT_GE(b2_toiCalls, 10);
}

} // namespace
