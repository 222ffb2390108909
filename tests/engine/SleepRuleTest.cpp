// SPDX-License-Identifier: MIT
#include <Dynamics/Islands/SleepRule.h>

#include <gtest/gtest.h>

/// The rule by itself: DynamicsSleepTest looks at worlds.
namespace
{

using namespace box2d;

constexpr float32 kStep = 1.0f / 60.0f;
constexpr float32 kSlow = 0.5f * b2_linearSleepTolerance;

/// A slow dynamic body that has rested for a while.
struct Rest
{
    BodyData body;
    SolverBody moved;
    SleepStep step{kStep, false};

    explicit Rest(float32 time = 0.25f)
    {
        body.mobility = Mobility::Dynamic;
        body.flags = kBodyAutoSleep;
        body.sleepTime = time;
        body.linearVelocity.Set(kSlow, 0.0f);
        moved.v.Set(kSlow, 0.0f);
        moved.d = kStep * moved.v;
    }
    float32 TimeAfter() const { return SleepTimeAfter(body, moved, step); }
};

TEST(SleepRule, CountsTheTimeOfASlowBody)
{
    const Rest rest;
    EXPECT_EQ(rest.TimeAfter(), 0.25f + kStep);
}

TEST(SleepRule, StartsAgainForAFastBody)
{
    Rest linear;
    linear.moved.v.x = 1.01f * b2_linearSleepTolerance;
    EXPECT_EQ(linear.TimeAfter(), 0.0f);
    Rest angular;
    angular.moved.w = -1.01f * b2_angularSleepTolerance;
    EXPECT_EQ(angular.TimeAfter(), 0.0f);
    Rest forbidden;
    forbidden.body.flags = 0;
    EXPECT_EQ(forbidden.TimeAfter(), 0.0f) << "SetSleepingAllowed(false)";
}

TEST(SleepRule, WaitsWhileADeepOverlapIsCorrected)
{
    Rest rest;
    rest.moved.d.x = 5.0f * kStep * b2_linearSleepTolerance;
    EXPECT_EQ(rest.TimeAfter(), 0.0f);
}

TEST(SleepRule, KeepsAPlatformAwakeAtAnySpeed)
{
    Rest rest;
    rest.body.mobility = Mobility::Kinematic;
    EXPECT_EQ(rest.TimeAfter(), 0.0f);
    rest.moved.v.SetZero();
    EXPECT_GT(rest.TimeAfter(), 0.25f);
}

TEST(SleepRule, WaitsWhileABodyTurnsBack)
{
    Rest rest(b2_timeToSleep);
    rest.moved.v.x = -kSlow;
    EXPECT_EQ(rest.TimeAfter(), b2_timeToSleep);
    rest.body.colorMask = 1;
    EXPECT_GT(rest.TimeAfter(), b2_timeToSleep) << "with contacts";
}

TEST(SleepRule, WaitsInSubStepsWhileABodySetsOff)
{
    Rest rest(0.94f * b2_timeToSleep);
    rest.moved.v.x = 1.5f * kSlow;
    EXPECT_GT(rest.TimeAfter(), rest.body.sleepTime);
    rest.step.inSubSteps = true;
    EXPECT_LT(rest.TimeAfter(), rest.body.sleepTime);
}

} // namespace
