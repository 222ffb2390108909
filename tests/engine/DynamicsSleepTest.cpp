// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

/// Falling asleep, waking, islands.
namespace
{

using namespace dynamics;

constexpr int kTimeToRest = 120; // steps: half a second of stillness and what it takes to settle

TEST(DynamicsSleep, ComesToAWholeStackInOneStep)
{
    Scene scene;
    scene.Ground();
    const std::vector<b2Body*> pile = Stack(scene, 0.0f, 5);
    int steps = 0;
    while (!AllAwake(pile, false) && steps < 600)
    {
        scene.Step();
        ++steps;
        EXPECT_TRUE(AllAwake(pile, true) || AllAwake(pile, false)) << "step " << steps;
    }
    EXPECT_GE(float32(steps) * kStep, b2_timeToSleep);
    EXPECT_LE(steps, kTimeToRest);
    for (const b2Body* box : pile)
    {
        EXPECT_EQ(box->GetLinearVelocity(), b2Vec2(0.0f, 0.0f));
        EXPECT_EQ(box->GetAngularVelocity(), 0.0f);
    }
}

TEST(DynamicsSleep, KeepsAStackInPlace)
{
    Scene scene;
    scene.Ground();
    const std::vector<b2Body*> pile = Stack(scene, 0.0f, 5);
    scene.Step(kTimeToRest);
    ASSERT_TRUE(AllAwake(pile, false));
    const b2Vec2 top = pile.back()->GetPosition();
    scene.Step(600);
    EXPECT_EQ(pile.back()->GetPosition(), top);
    EXPECT_TRUE(AllAwake(pile, false));
}

TEST(DynamicsSleep, EndsForTheWholeStackAtAnImpact)
{
    Scene scene;
    scene.Ground();
    const std::vector<b2Body*> pile = Stack(scene, 0.0f, 5);
    scene.Step(kTimeToRest);
    ASSERT_TRUE(AllAwake(pile, false));
    b2Body* ball = scene.Ball(-5.0f, 4.5f, 0.2f);
    ball->SetLinearVelocity(b2Vec2(20.0f, 0.0f));
    int steps = 0;
    while (!pile.front()->IsAwake() && steps < 60)
    {
        scene.Step();
        ++steps;
        EXPECT_TRUE(AllAwake(pile, true) || AllAwake(pile, false)) << "step " << steps;
    }
    EXPECT_LT(steps, 60);
}

TEST(DynamicsSleep, EndsForTheWholeStackWhenOneBodyIsWoken)
{
    Scene scene;
    scene.Ground();
    const std::vector<b2Body*> pile = Stack(scene, 0.0f, 5);
    scene.Step(kTimeToRest);
    ASSERT_TRUE(AllAwake(pile, false));
    pile[2]->SetAwake(true);
    EXPECT_TRUE(AllAwake(pile, true));
}

TEST(DynamicsSleep, EndsForASingleBodyOfAnAwakeStack)
{
    Scene scene;
    scene.Ground();
    const std::vector<b2Body*> pile = Stack(scene, 0.0f, 3);
    scene.Step(5);
    pile[1]->SetAwake(false);
    EXPECT_FALSE(pile[1]->IsAwake());
    EXPECT_TRUE(pile[0]->IsAwake());
    scene.Step();
    EXPECT_TRUE(AllAwake(pile, true));
    scene.Step(kTimeToRest);
    EXPECT_TRUE(AllAwake(pile, false));
}

TEST(DynamicsSleep, ComesToBoxesThatABallRolledOver)
{
    Scene scene;
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, -1.0f);
    Scene::AddBox(ground, 500.0f, 1.0f);
    b2Body* left = scene.Box(-0.55f, 0.5f);
    b2Body* right = scene.Box(0.55f, 0.5f);
    b2Body* ball = scene.Body(b2_dynamicBody, -0.8f, 1.26f);
    Scene::AddBall(ball, 0.25f, 0.0f);
    ball->SetLinearVelocity(b2Vec2(4.0f, 0.0f));
    scene.Step(300);
    ASSERT_GT(ball->GetPosition().x, 5.0f);
    EXPECT_GT(ball->GetLinearVelocity().x, 1.0f);
    EXPECT_TRUE(ball->IsAwake());
    EXPECT_FALSE(left->IsAwake());
    EXPECT_FALSE(right->IsAwake());
    EXPECT_EQ(WhyBroken(scene.world, true), "");
}

TEST(DynamicsSleep, EndsIndependentlyForSeparatedBodies)
{
    Scene scene;
    scene.Ground();
    b2Body* left = scene.Box(-2.0f, 0.5f);
    b2Body* right = scene.Box(2.0f, 0.5f);
    b2DistanceJointDef def;
    def.Initialize(left, right, left->GetPosition(), right->GetPosition());
    b2Joint* joint = scene.world.CreateJoint(&def);
    scene.Step(kTimeToRest);
    ASSERT_FALSE(left->IsAwake());
    left->SetAwake(true);
    EXPECT_TRUE(right->IsAwake()) << "joined";
    scene.world.DestroyJoint(joint);
    scene.Step(kTimeToRest);
    ASSERT_FALSE(left->IsAwake());
    left->SetAwake(true);
    EXPECT_FALSE(right->IsAwake()) << "no longer joined";
}

TEST(DynamicsSleep, NeverComesInAWorldThatForbidsIt)
{
    Scene scene;
    scene.world.SetAllowSleeping(false);
    scene.Ground();
    const std::vector<b2Body*> pile = Stack(scene, 0.0f, 3);
    scene.Step(300);
    EXPECT_TRUE(AllAwake(pile, true));
    scene.world.SetAllowSleeping(true);
    scene.Step(kTimeToRest);
    EXPECT_TRUE(AllAwake(pile, false));
    scene.world.SetAllowSleeping(false);
    EXPECT_TRUE(AllAwake(pile, true));
}

TEST(DynamicsSleep, NeverComesToAStackWithABodyThatMayNotSleep)
{
    Scene scene;
    scene.Ground();
    const std::vector<b2Body*> pile = Stack(scene, 0.0f, 3);
    const std::vector<b2Body*> other = Stack(scene, 10.0f, 3);
    pile[1]->SetSleepingAllowed(false);
    scene.Step(300);
    EXPECT_TRUE(AllAwake(pile, true));
    EXPECT_TRUE(AllAwake(other, false));
}

TEST(DynamicsSleep, NeverComesToABodyOnAMovingPlatform)
{
    Scene scene;
    b2Body* platform = scene.Body(b2_kinematicBody, 0.0f, -0.5f);
    Scene::AddBox(platform, 3.0f, 0.5f);
    platform->SetLinearVelocity(b2Vec2(0.005f, 0.0f)); // slower than what counts as moving
    b2Body* box = scene.Box(0.0f, 0.5f);
    scene.Step(600);
    EXPECT_TRUE(platform->IsAwake());
    EXPECT_TRUE(box->IsAwake());
    EXPECT_NEAR(platform->GetPosition().x, 0.05f, 1e-4f);
    EXPECT_NEAR(box->GetPosition().x, 0.05f, 2e-3f);
}

TEST(DynamicsSleep, ComesAndEndsForAPlatformWithItsLoad)
{
    Scene scene;
    b2Body* platform = scene.Body(b2_kinematicBody, 0.0f, -0.5f);
    Scene::AddBox(platform, 3.0f, 0.5f);
    b2Body* box = scene.Box(0.0f, 0.5f);
    scene.Step(kTimeToRest);
    EXPECT_FALSE(platform->IsAwake());
    EXPECT_FALSE(box->IsAwake());
    platform->SetLinearVelocity(b2Vec2(0.5f, 0.0f));
    scene.Step();
    EXPECT_TRUE(box->IsAwake());
    scene.Step(60);
    // It slips until friction (0.2 g) has brought it to the platform's speed.
    EXPECT_NEAR(platform->GetPosition().x - box->GetPosition().x, 0.5f * 0.5f / (2.0f * 2.0f),
                0.01f);
}

TEST(DynamicsSleep, EndsForJoinedBodiesWhenAPlatformStarts)
{
    Scene scene;
    b2Body* trolley = scene.Body(b2_kinematicBody, 0.0f, 5.0f);
    Scene::AddBox(trolley, 0.5f, 0.1f);
    b2Body* load = scene.Box(0.0f, 2.0f);
    b2DistanceJointDef def;
    def.Initialize(trolley, load, trolley->GetPosition(), load->GetPosition());
    scene.world.CreateJoint(&def);
    scene.Step(kTimeToRest);
    ASSERT_FALSE(load->IsAwake());
    ASSERT_FALSE(trolley->IsAwake());
    trolley->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    scene.Step(2);
    EXPECT_TRUE(load->IsAwake());
    scene.Step(58);
    EXPECT_NEAR(b2Distance(trolley->GetPosition(), load->GetPosition()), 3.0f, 0.02f);
}

enum class Removal
{
    DestroyBody,
    DestroyFixture,
    Deactivate,
    MoveAway,
    Filter,
    BecomeSensor,
};

class DynamicsSupport : public testing::TestWithParam<Removal>
{};

TEST_P(DynamicsSupport, LetsASleepingStackFallWhenRemoved)
{
    Scene scene;
    b2Body* ground = scene.Ground();
    const std::vector<b2Body*> pile = Stack(scene, 0.0f, 3);
    scene.Step(kTimeToRest);
    ASSERT_TRUE(AllAwake(pile, false));
    b2Filter nothing;
    nothing.maskBits = 0;
    switch (GetParam())
    {
    case Removal::DestroyBody:
        scene.world.DestroyBody(ground);
        break;
    case Removal::DestroyFixture:
        ground->DestroyFixture(ground->GetFixtureList());
        break;
    case Removal::Deactivate:
        ground->SetActive(false);
        break;
    case Removal::MoveAway:
        ground->SetTransform(b2Vec2(0.0f, -20.0f), 0.0f);
        break;
    case Removal::Filter:
        ground->GetFixtureList()->SetFilterData(nothing);
        break;
    case Removal::BecomeSensor:
        ground->GetFixtureList()->SetSensor(true);
        break;
    }
    scene.Step(30);
    EXPECT_TRUE(AllAwake(pile, true));
    EXPECT_LT(pile[0]->GetPosition().y, 0.0f);
    EXPECT_LT(pile[2]->GetPosition().y, 2.0f);
    EXPECT_EQ(WhyBroken(scene.world, true), "");
}

INSTANTIATE_TEST_SUITE_P(Ways, DynamicsSupport,
                         testing::Values(Removal::DestroyBody, Removal::DestroyFixture,
                                         Removal::Deactivate, Removal::MoveAway, Removal::Filter,
                                         Removal::BecomeSensor));

TEST(DynamicsSleep, EndsForABoxMovedIntoTheAir)
{
    Scene scene;
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.5f);
    scene.Step(kTimeToRest);
    ASSERT_FALSE(box->IsAwake());
    box->SetTransform(b2Vec2(0.0f, 5.0f), 0.0f);
    scene.Step(10);
    EXPECT_LT(box->GetPosition().y, 5.0f);
    EXPECT_FALSE(box->GetContactList() && box->GetContactList()->contact->IsTouching());
}

TEST(DynamicsSleep, EndsForALoadWhenItsAnchorIsDeactivatedOrMoved)
{
    for (const bool move : {false, true})
    {
        Scene scene;
        b2Body* anchor = scene.Body(b2_staticBody, 0.0f, 5.0f);
        b2Body* load = scene.Box(0.0f, 2.0f);
        b2DistanceJointDef def;
        def.Initialize(anchor, load, anchor->GetPosition(), load->GetPosition());
        scene.world.CreateJoint(&def);
        scene.Step(kTimeToRest);
        ASSERT_FALSE(load->IsAwake());
        if (move)
        {
            anchor->SetTransform(b2Vec2(1.0f, 5.0f), 0.0f);
        }
        else
        {
            anchor->SetActive(false);
        }
        scene.Step(30);
        EXPECT_TRUE(load->IsAwake());
        EXPECT_NE(load->GetPosition(), b2Vec2(0.0f, 2.0f));
    }
}

TEST(DynamicsSleep, ComesDespiteTinyForcesAndEndsByALargeOne)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* box = scene.Box(0.0f, 0.0f);
    for (int i = 0; i < 120; ++i)
    {
        box->ApplyForceToCenter(b2Vec2(1e-5f, 0.0f));
        scene.Step();
    }
    EXPECT_FALSE(box->IsAwake()) << "as slow as this it may sleep";
    box->ApplyForceToCenter(b2Vec2(1.0f, 0.0f));
    EXPECT_TRUE(box->IsAwake());
    scene.Step();
    EXPECT_GT(box->GetLinearVelocity().x, 0.0f);
}

TEST(DynamicsSleep, CanBeChangedByAListenerWithinAStep)
{
    struct Sleeper : b2ContactListener
    {
        void PostSolve(b2Contact* contact, const b2ContactImpulse*) override
        {
            contact->GetFixtureA()->GetBody()->SetAwake(false);
            sleeping->SetAwake(true);
        }
        b2Body* sleeping = nullptr;
    };
    Scene scene(b2Vec2(0.0f, 0.0f));
    Sleeper listener;
    scene.world.SetContactListener(&listener);
    b2Body* hit = scene.Box(0.0f, 0.0f);
    b2Body* hitting = scene.Box(-1.2f, 0.0f);
    b2Body* far = scene.Box(0.0f, 10.0f);
    far->SetLinearVelocity(b2Vec2(0.0f, 1.0f));
    listener.sleeping = scene.Box(0.0f, 20.0f);
    listener.sleeping->SetAwake(false);
    hitting->SetLinearVelocity(b2Vec2(15.0f, 0.0f));
    for (int i = 0; i < 10; ++i)
    {
        scene.Step();
        ASSERT_EQ(WhyBroken(scene.world, false), "");
    }
    EXPECT_TRUE(listener.sleeping->IsAwake());
    EXPECT_EQ(listener.sleeping->GetPosition(), b2Vec2(0.0f, 20.0f));
    EXPECT_EQ(far->GetLinearVelocity(), b2Vec2(0.0f, 1.0f));
    EXPECT_EQ(hit->GetPosition().y, 0.0f);
}

} // namespace
