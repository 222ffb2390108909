// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

/// No body passes through an obstacle, however fast. A step moves a body by 2 m at most
/// (b2_maxTranslation), so 300 m/s are also tested at 240 Hz.
namespace
{

using namespace dynamics;

struct Shot
{
    float32 speed;
    float32 hertz;
};

void PrintTo(const Shot& shot, std::ostream* out)
{
    *out << shot.speed << " m/s at " << shot.hertz << " Hz";
}

class DynamicsBullets : public testing::TestWithParam<Shot>
{};

TEST_P(DynamicsBullets, StopAtAThinWall)
{
    for (const bool edge : {false, true})
    {
        for (int i = 0; i < 40; ++i)
        {
            Scene scene(b2Vec2(0.0f, 0.0f));
            b2Body* wall = scene.Body(b2_staticBody, 10.0f, 0.0f);
            if (edge)
            {
                b2EdgeShape shape;
                shape.Set(b2Vec2(0.0f, -10.0f), b2Vec2(0.0f, 10.0f));
                wall->CreateFixture(&shape, 0.0f);
            }
            else
            {
                Scene::AddBox(wall, 0.01f, 10.0f);
            }
            b2Body* ball = i % 2 == 0 ? scene.Ball(0.05f * float32(i), 0.0f, 0.05f)
                                      : scene.Box(0.05f * float32(i), 0.0f, 0.05f, 0.03f);
            ball->SetLinearVelocity(b2Vec2(GetParam().speed, 1.0f));
            ball->SetAngularVelocity(float32(i % 5));
            for (int step = 0; step < 60; ++step)
            {
                scene.world.Step(1.0f / GetParam().hertz, 8, 3);
                ASSERT_LT(ball->GetPosition().x, 10.0f) << "start " << i << ", step " << step;
            }
            if (i % 2 == 0) // a box that hits with a corner spins and flies back
            {
                EXPECT_GT(ball->GetPosition().x, 9.9f);
                EXPECT_NEAR(ball->GetLinearVelocity().x, 0.0f, 1e-3f);
            }
        }
    }
}

TEST_P(DynamicsBullets, HitEachOther)
{
    for (int i = 0; i < 40; ++i)
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        b2Body* left = scene.Ball(-5.0f - 0.05f * float32(i), 0.0f, 0.05f);
        b2Body* right = scene.Ball(5.0f, 0.0f, 0.05f);
        left->SetBullet(true);
        left->SetLinearVelocity(b2Vec2(GetParam().speed, 0.0f));
        right->SetLinearVelocity(b2Vec2(-GetParam().speed, 0.0f));
        for (int step = 0; step < 60; ++step)
        {
            scene.world.Step(1.0f / GetParam().hertz, 8, 3);
            ASSERT_LT(left->GetPosition().x, right->GetPosition().x) << i << ", step " << step;
        }
    }
}

TEST_P(DynamicsBullets, MoveASleepingBoxInsteadOfPassingIt)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* box = scene.Box(10.0f, 0.0f, 0.02f, 0.5f);
    box->SetAwake(false);
    b2Body* ball = scene.Ball(0.3f, 0.0f, 0.05f);
    ball->SetBullet(true);
    ball->SetLinearVelocity(b2Vec2(GetParam().speed, 0.0f));
    for (int step = 0; step < 60; ++step)
    {
        scene.world.Step(1.0f / GetParam().hertz, 8, 3);
        ASSERT_LT(ball->GetPosition().x, box->GetPosition().x) << "step " << step;
    }
    EXPECT_GT(box->GetLinearVelocity().x, 1.0f);
}

INSTANTIATE_TEST_SUITE_P(Speeds, DynamicsBullets,
                         testing::Values(Shot{100.0f, 60.0f}, Shot{300.0f, 60.0f},
                                         Shot{300.0f, 240.0f}));

TEST(DynamicsContinuous, StopsAThinSpinningRodAtAnEdge)
{
    std::mt19937 random(5);
    const auto real = [&](float32 low, float32 high) {
        return low + (high - low) * float32(random() % 10001u) / 10000.0f;
    };
    for (int i = 0; i < 200; ++i)
    {
        Scene scene;
        b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
        b2EdgeShape edge;
        edge.Set(b2Vec2(-40.0f, 0.0f), b2Vec2(40.0f, 0.0f));
        wall->CreateFixture(&edge, 0.0f);
        b2Body* rod = scene.Body(b2_dynamicBody, 0.0f, real(1.5f, 4.0f), real(0.0f, 3.0f));
        Scene::AddBox(rod, 1.0f, 0.02f);
        rod->SetLinearVelocity(b2Vec2(real(-10.0f, 10.0f), real(-100.0f, -20.0f)));
        rod->SetAngularVelocity(real(-60.0f, 60.0f));
        for (int step = 0; step < 120; ++step)
        {
            scene.Step();
            ASSERT_GT(rod->GetPosition().y, 0.0f) << "case " << i << ", step " << step;
        }
    }
}

TEST(DynamicsContinuous, StopsRodThatIsThinAlongDiagonal)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.Wall(5.0f, 0.01f);
    for (int i = 0; i < 10; ++i)
    {
        b2Body* rod = scene.Body(b2_dynamicBody, 0.1f * float32(i), float32(2 * i - 9));
        b2PolygonShape shape;
        shape.SetAsBox(0.5f, 0.01f, b2Vec2(0.0f, 0.0f), 0.25f * b2_pi);
        rod->CreateFixture(&shape, 1.0f);
        rod->SetTransform(rod->GetPosition(), 0.25f * b2_pi); // upright
        rod->SetLinearVelocity(b2Vec2(15.0f + float32(i), 0.0f));
    }
    for (int step = 0; step < 120; ++step)
    {
        scene.Step();
        for (const b2Body* b = scene.world.GetBodyList(); b; b = b->GetNext())
        {
            ASSERT_LT(b->GetPosition().x, 5.1f) << "step " << step;
        }
    }
}

TEST(DynamicsContinuous, MovesASleepingBallBeforeAFastPlatform)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* ball = scene.Ball(1.0f, 0.0f, 0.1f);
    ball->SetAwake(false);
    b2Body* paddle = scene.Body(b2_kinematicBody, 0.0f, 0.0f);
    Scene::AddBox(paddle, 0.05f, 1.0f);
    paddle->SetLinearVelocity(b2Vec2(110.0f, 0.0f));
    for (int step = 0; step < 30; ++step)
    {
        scene.Step();
        ASSERT_GT(ball->GetPosition().x, paddle->GetPosition().x) << "step " << step;
    }
}

// A body on the platform makes it part of an impact as a neighbour. That must have no effect.
TEST(DynamicsContinuous, StopsABallAtAPlatformThatWasHitBefore)
{
    for (int i = 0; i < 20; ++i)
    {
        Scene scene;
        b2EdgeShape edge;
        edge.Set(b2Vec2(-50.0f, 0.0f), b2Vec2(50.0f, 0.0f));
        Scene::Add(scene.Body(b2_kinematicBody, 0.0f, 0.0f), edge, 0.2f, 0.0f);
        scene.Box(0.0f, 0.07f, 0.5f, 0.05f);
        scene.Step(120);
        b2Body* bullet = scene.Ball(0.0f, 5.0f, 0.05f);
        bullet->SetBullet(true);
        bullet->SetLinearVelocity(b2Vec2(0.0f, -100.0f));
        scene.Step(10);
        b2Body* ball = scene.Ball(5.0f, 3.0f + 0.05f * float32(i), 0.05f);
        ball->SetLinearVelocity(b2Vec2(0.0f, -60.0f));
        scene.Step(60);
        EXPECT_GT(ball->GetPosition().y, 0.0f) << "from " << 3.0f + 0.05f * float32(i) << " m";
    }
}

TEST(DynamicsContinuous, KeepsAFastBallBetweenTwoWalls)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    for (const float32 x : {-0.5f, 0.5f})
    {
        b2Body* wall = scene.Body(b2_staticBody, x, 0.0f);
        Scene::AddBox(wall, 0.01f, 100.0f, 0.0f, 1.0f);
    }
    b2Body* ball = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    Scene::AddBall(ball, 0.05f, 0.0f, 1.0f);
    ball->SetLinearVelocity(b2Vec2(110.0f, 3.0f));
    for (int step = 0; step < 300; ++step)
    {
        scene.Step();
        ASSERT_LT(b2Abs(ball->GetPosition().x), 0.5f) << "step " << step;
        ASSERT_TRUE(ball->GetPosition().IsValid());
    }
    EXPECT_LE(ball->GetLinearVelocity().Length(), 111.0f) << "it gains no energy";
}

TEST(DynamicsContinuous, CanBeSwitchedOff)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetContinuousPhysics(false);
    scene.Wall(5.0f, 0.01f);
    b2Body* ball = scene.Ball(0.0f, 0.0f, 0.05f);
    ball->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    scene.Step(10);
    EXPECT_GT(ball->GetPosition().x, 5.5f) << "which shows that the other tests test something";
}

TEST(DynamicsContinuous, LetsBulletsPassSensors)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.Wall(5.0f, 0.01f)->GetFixtureList()->SetSensor(true);
    b2Body* ball = scene.Ball(0.0f, 0.0f, 0.05f);
    ball->SetBullet(true);
    ball->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    scene.Step(6);
    EXPECT_NEAR(ball->GetPosition().x, 10.0f, 1e-3f);
}

struct Counter : b2ContactListener
{
    void BeginContact(b2Contact*) override { ++begun; }
    void EndContact(b2Contact*) override { ++ended; }
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        ++preSolved;
        if (disable)
        {
            contact->SetEnabled(false);
        }
    }
    void PostSolve(b2Contact*, const b2ContactImpulse* impulse) override
    {
        ++postSolved;
        largest = b2Max(largest, impulse->normalImpulses[0]);
    }
    int begun = 0, ended = 0, preSolved = 0, postSolved = 0;
    float32 largest = 0.0f;
    bool disable = false;
};

TEST(DynamicsContinuous, ReportsImpulseOfImpactWithinStep)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Counter counter;
    scene.world.SetContactListener(&counter);
    scene.Wall(5.0f, 0.01f);
    b2Body* ball = scene.Ball(0.0f, 0.0f, 0.05f);
    ball->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    scene.Step(10);
    EXPECT_EQ(counter.begun, 1);
    EXPECT_EQ(counter.ended, 0);
    EXPECT_GE(counter.preSolved, 1);
    EXPECT_NEAR(counter.largest, 100.0f * ball->GetMass(), 0.01f);
}

TEST(DynamicsContinuous, SolvesAnImpactInACornerWithBothWalls)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Counter counter;
    scene.world.SetContactListener(&counter);
    for (const b2Vec2& end : {b2Vec2(0.0f, 5.0f), b2Vec2(5.0f, 0.0f)})
    {
        b2EdgeShape edge;
        edge.Set(b2Vec2_zero, end);
        Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), edge, 0.0f, 1.0f);
    }
    b2Body* ball = scene.Body(b2_dynamicBody, 1.3f, 1.3f);
    Scene::AddBall(ball, 0.1f, 0.0f, 1.0f);
    ball->SetBullet(true);
    ball->SetLinearVelocity(b2Vec2(-50.0f, -50.0f));
    scene.Step(2);
    EXPECT_NEAR(ball->GetLinearVelocity().x, 50.0f, 0.1f);
    EXPECT_NEAR(ball->GetLinearVelocity().y, 50.0f, 0.1f);
    EXPECT_EQ(counter.postSolved, 2) << "one impact with two contacts";
}

/// Both walls at once: what one gives back turns the box against the other.
TEST(DynamicsContinuous, KeepsTheEnergyOfABoxSpinningIntoACorner)
{
    double minimum = 1.0; // of what it had
    double maximum = 1.0;
    for (int i = 0; i < 500; ++i)
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        scene.world.SetSubStepCount(4);
        const b2Vec2 corner[] = {{10.0f, 0.0f}, {0.0f, 0.0f}, {0.0f, 10.0f}};
        b2ChainShape walls;
        walls.CreateChain(corner, 3);
        Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), walls, 0.0f, 1.0f);
        b2Body* box = scene.Body(b2_dynamicBody, 1.0f, 1.0f, 0.1f * float32(i));
        Scene::AddBox(box, 0.15f, 0.15f, 0.0f, 1.0f);
        box->SetLinearVelocity(b2Vec2(-100.0f, -90.0f - 0.04f * float32(i)));
        box->SetAngularVelocity(-1000.0f + 4.0f * float32(i));
        const auto energy = [box] {
            const double w = double(box->GetAngularVelocity());
            return 0.5 * double(box->GetMass()) * double(box->GetLinearVelocity().LengthSquared()) +
                   0.5 * double(box->GetInertia()) * w * w;
        };
        const double before = energy();
        scene.Step();
        ASSERT_GT(box->GetLinearVelocity().x, 0.0f) << i;
        minimum = std::min(minimum, energy() / before);
        maximum = std::max(maximum, energy() / before);
    }
    EXPECT_GT(minimum, 0.9995);
    EXPECT_LT(maximum, 1.0001);
}

TEST(DynamicsContinuous, LetsABodyContinueWhenItsContactIsDisabled)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Counter counter;
    counter.disable = true;
    scene.world.SetContactListener(&counter);
    scene.Wall(5.0f, 0.01f);
    b2Body* ball = scene.Ball(0.5f, 0.0f, 0.05f);
    ball->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    scene.Step(6);
    EXPECT_NEAR(ball->GetPosition().x, 10.5f, 1e-3f);
    EXPECT_EQ(counter.begun, 1);
    EXPECT_EQ(counter.ended, 1);
    EXPECT_EQ(counter.preSolved, 1) << "once for the one impact";
    EXPECT_EQ(counter.postSolved, 0);
}

/// Balls that fall side by side, closer than an impact is looked for, and hit the ground at once.
std::vector<b2Vec2> VelocitiesOfBullets(int count)
{
    Scene scene;
    scene.world.SetSubStepCount(2);
    scene.Ground()->GetFixtureList()->SetRestitution(1.0f);
    std::vector<b2Body*> balls;
    for (int i = 0; i < count; ++i)
    {
        b2Body* ball = scene.Ball(float32(i) * (0.2f + 0.4f * b2_linearSlop), 2.0f, 0.1f);
        ball->SetBullet(true);
        ball->SetLinearVelocity(b2Vec2(0.0f, -20.0f));
        balls.push_back(ball);
    }
    scene.Step(30);
    std::vector<b2Vec2> velocities;
    for (const b2Body* ball : balls)
    {
        velocities.push_back(ball->GetLinearVelocity());
    }
    return velocities;
}

TEST(DynamicsContinuous, KeepsVelocitiesWhereNothingIsHit)
{
    const b2Vec2 alone = VelocitiesOfBullets(1)[0];
    EXPECT_GT(alone.y, 10.0f);
    for (const b2Vec2& velocity : VelocitiesOfBullets(3))
    {
        EXPECT_NEAR(velocity.x, 0.0f, 1e-6f);
        EXPECT_NEAR(velocity.y, alone.y, 1e-4f);
    }
}

TEST(DynamicsContinuous, CallsPreSolveOnceForDisabledBulletPair)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Counter counter;
    counter.disable = true;
    scene.world.SetContactListener(&counter);
    b2Body* left = scene.Ball(-1.0f, 0.0f, 0.05f);
    b2Body* right = scene.Ball(1.1f, 0.0f, 0.05f);
    left->SetBullet(true);
    right->SetBullet(true);
    left->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    right->SetLinearVelocity(b2Vec2(-100.0f, 0.0f));
    scene.Step();
    EXPECT_EQ(counter.preSolved, 1);
    EXPECT_GT(left->GetPosition().x, right->GetPosition().x);
}

TEST(DynamicsContinuous, StopsAtEveryImpactWithSubStepping)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetSubStepping(true);
    scene.Wall(1.2f, 0.01f);
    scene.Wall(-1.2f, 0.01f);
    b2Body* left = scene.Ball(0.0f, 1.0f, 0.05f);
    b2Body* right = scene.Ball(0.0f, -1.0f, 0.05f);
    left->SetLinearVelocity(b2Vec2(-100.0f, 0.0f));
    right->SetLinearVelocity(b2Vec2(110.0f, 0.0f));
    scene.Step();
    const bool leftStopped = b2Abs(left->GetLinearVelocity().x) < 1.0f;
    const bool rightStopped = b2Abs(right->GetLinearVelocity().x) < 1.0f;
    EXPECT_TRUE(rightStopped) << "the faster one hits first";
    EXPECT_FALSE(leftStopped) << "the other waits for the next call";
    scene.Step();
    EXPECT_LT(b2Abs(left->GetLinearVelocity().x), 1.0f);
    scene.Step(5);
    EXPECT_LT(b2Abs(left->GetPosition().x), 1.2f);
    EXPECT_LT(b2Abs(right->GetPosition().x), 1.2f);
    EXPECT_EQ(WhyBroken(scene.world, false), "");
}

TEST(DynamicsContinuous, EndsTheStepWithBulletsInAStack)
{
    Scene scene;
    scene.Ground();
    const std::vector<b2Body*> pile = Stack(scene, 0.0f, 8);
    for (b2Body* box : pile)
    {
        box->SetBullet(true);
    }
    for (int i = 0; i < 20; ++i)
    {
        b2Body* bullet = scene.Ball(-10.0f, 0.3f + 0.4f * float32(i), 0.1f);
        bullet->SetBullet(true);
        bullet->SetLinearVelocity(b2Vec2(115.0f, 0.0f));
    }
    for (int step = 0; step < 120; ++step)
    {
        scene.Step();
        ASSERT_EQ(WhyBroken(scene.world, true), "") << step;
    }
    for (const b2Body* b = scene.world.GetBodyList(); b; b = b->GetNext())
    {
        EXPECT_GT(b->GetPosition().y, -1.1f);
    }
}

/// Accelerates hit bodies upwards.
struct Launcher : public b2ContactListener
{
    void PreSolve(b2Contact*, const b2Manifold*) override
    {
        platform->SetLinearVelocity(b2Vec2(0.0f, 90.0f));
    }
    b2Body* platform = nullptr;
};

TEST(DynamicsContinuous, UpdatesBoxOfPlatformMovedByListener)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    Launcher launcher;
    launcher.platform = scene.Body(b2_kinematicBody, 0.0f, 0.0f);
    Scene::AddBox(launcher.platform, 0.5f, 0.5f);
    launcher.platform->SetLinearVelocity(b2Vec2(0.0f, 0.1f));
    b2Body* bullet = scene.Ball(-2.0f, 0.0f, 0.1f);
    bullet->SetBullet(true);
    bullet->SetLinearVelocity(b2Vec2(110.0f, 0.0f));
    scene.world.SetContactListener(&launcher);
    scene.Step();
    scene.world.SetContactListener(nullptr);
    ASSERT_GT(launcher.platform->GetLinearVelocity().y, 1.0f);
    b2AABB tight;
    const b2Fixture* fixture = launcher.platform->GetFixtureList();
    fixture->GetShape()->ComputeAABB(&tight, launcher.platform->GetTransform(), 0);
    EXPECT_TRUE(fixture->GetAABB(0).Contains(tight));
}

/// Removes itself when it is first called.
struct OnceOnly : public b2ContactListener
{
    void PostSolve(b2Contact*, const b2ContactImpulse*) override
    {
        ++calls;
        world->SetContactListener(nullptr);
    }
    b2World* world = nullptr;
    int calls = 0;
};

TEST(DynamicsContinuous, DoesNotCallListenerRemovedInImpact)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    b2Body* walls = scene.Body(b2_staticBody, 0.0f, 0.0f);
    for (const float32 y : {-0.1f, 0.1f}) // the ball meets both in one impact
    {
        b2EdgeShape shape;
        shape.Set(b2Vec2(0.0f, y), b2Vec2(1.0f, 9.0f * y));
        walls->CreateFixture(&shape, 0.0f);
    }
    b2Body* bullet = scene.Ball(-1.0f, 0.0f, 0.15f);
    bullet->SetBullet(true);
    bullet->SetLinearVelocity(b2Vec2(110.0f, 0.0f));
    OnceOnly listener;
    listener.world = &scene.world;
    scene.world.SetContactListener(&listener);
    scene.Step(2);
    EXPECT_EQ(listener.calls, 1);
}

// The parts of a step that stops at each impact may be of different lengths.
TEST(DynamicsContinuous, UpdatesBoxOfPlatformTurningWithinStep)
{
    Scene scene(b2Vec2(0.0f, 0.0f));
    scene.world.SetSubStepping(true);
    b2Body* bar = scene.Body(b2_kinematicBody, 0.0f, 0.0f);
    Scene::AddBox(bar, 20.0f, 0.2f);
    bar->SetAngularVelocity(-8.0f);
    // One for each arm, hit one right after the other.
    for (int i = 0; i < 24; ++i)
    {
        const float32 angle =
            -0.25f - 0.26f * float32(i / 2) + (i % 2 == 0 ? 0.0f : b2_pi - 0.004f);
        scene.Ball(12.0f * std::cos(angle), 12.0f * std::sin(angle), 0.1f);
    }
    struct Listener : public b2ContactListener
    {
        void BeginContact(b2Contact*) override { hit = true; }
        bool hit = false;
    };
    Listener listener;
    scene.world.SetContactListener(&listener);
    for (int i = 0; i < 480; ++i)
    {
        const bool wasHit = listener.hit;
        listener.hit = false;
        scene.world.Step(wasHit ? 1.0f / 30.0f : 1.0f / 240.0f, 8, 3);
        ASSERT_EQ(WhyBroken(scene.world, false), "") << i;
    }
}

/// A sub-stepped world with a ball that hits a wall early in the first step, and so breaks it off.
struct BrokenOff : public Scene
{
    BrokenOff() : Scene(b2Vec2(0.0f, 0.0f))
    {
        world.SetSubStepping(true);
        Wall(-20.0f, 0.01f);
        Ball(-19.8f, 0.0f, 0.05f)->SetLinearVelocity(b2Vec2(-100.0f, 0.0f));
    }
};

TEST(DynamicsContinuous, EndsPartialStepWithoutContinuousPhysics)
{
    BrokenOff scene;
    b2Body* free = scene.Ball(0.0f, 0.0f, 0.05f);
    free->SetLinearVelocity(b2Vec2(6.0f, 0.0f));
    scene.Step();
    EXPECT_FLOAT_EQ(free->GetPosition().x, 0.1f);
    scene.world.SetContinuousPhysics(false);
    scene.Step();
    EXPECT_FLOAT_EQ(free->GetPosition().x, 0.2f) << "a step of its own";
    scene.Step();
    EXPECT_FLOAT_EQ(free->GetPosition().x, 0.3f);
}

// Thin, so that its box has hardly any margin.
TEST(DynamicsContinuous, MovesAPlatformThroughImpactsUnchanged)
{
    BrokenOff scene;
    b2Body* platforms[2];
    for (int i = 0; i < 2; ++i)
    {
        platforms[i] = scene.Body(b2_kinematicBody, 0.0f, 20.0f * float32(i));
        Scene::AddBox(platforms[i], 0.002f, 1.0f);
        platforms[i]->SetLinearVelocity(b2Vec2(0.37f, 0.0f));
    }
    b2Body* bullet = scene.Ball(1.0f, 0.0f, 0.05f);
    bullet->SetLinearVelocity(b2Vec2(-100.0f, 0.0f));
    scene.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_LT(bullet->GetPosition().x, -0.5f) << "its impact is for the next part";
    scene.world.Step(1.0f / 30.0f, 8, 3);
    EXPECT_GT(bullet->GetPosition().x, 0.0f);
    EXPECT_EQ(WhyBroken(scene.world, false), "");
    EXPECT_EQ(platforms[0]->GetPosition().x, platforms[1]->GetPosition().x);
}

// They hit each other and the wall by turns, more often than a step has impacts.
TEST(DynamicsContinuous, KeepsLightBodyBetweenHeavyBulletAndWall)
{
    for (int i = 0; i < 100; ++i)
    {
        Scene scene(b2Vec2(0.0f, 0.0f));
        scene.world.SetSubStepCount(i % 2 == 0 ? 1 : 4);
        b2EdgeShape wall;
        wall.Set(b2Vec2(0.0f, -20.0f), b2Vec2(0.0f, 20.0f));
        Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), wall, 0.5f, 0.3f);
        b2Body* light = scene.Body(b2_dynamicBody, 0.8f, 0.0f, 0.03f * float32(i));
        Scene::AddBox(light, 0.6f, 0.1f, 0.9f, 0.3f)->SetDensity(1.0f);
        light->ResetMassData();
        b2Body* heavy = scene.Body(b2_dynamicBody, 4.0f, 0.01f * float32(i % 7), 0.1f * float32(i));
        Scene::AddBox(heavy, 0.2f, 0.15f, 0.6f, 0.3f)->SetDensity(50.0f);
        heavy->ResetMassData();
        heavy->SetBullet(true);
        heavy->SetLinearVelocity(b2Vec2(-90.0f, 0.0f));
        for (int step = 0; step < 30; ++step)
        {
            scene.Step();
            ASSERT_GT(light->GetPosition().x, 0.0f) << "case " << i << ", step " << step;
            ASSERT_GT(heavy->GetPosition().x, 0.0f) << "case " << i << ", step " << step;
        }
    }
}

/// Puts a body to sleep in one of the callbacks.
struct Lullaby : public b2ContactListener
{
    b2Body* body = nullptr;
    int when = 0;
    int calls = 0;

    void Sing(int now)
    {
        if (now == when)
        {
            body->SetAwake(false);
            ++calls;
        }
    }
    void BeginContact(b2Contact*) override { Sing(0); }
    void PreSolve(b2Contact*, const b2Manifold*) override { Sing(1); }
    void PostSolve(b2Contact*, const b2ContactImpulse*) override { Sing(2); }
};

// After an impact stops a body, awake bodies joined to it are pulled back to it.
TEST(DynamicsContinuous, LetsListenerPutJoinedBodyToSleep)
{
    for (const int32 subSteps : {1, 2, 8})
    {
        for (const int when : {0, 1, 2})
        {
            Scene scene(b2Vec2(0.0f, 0.0f));
            scene.world.SetSubStepCount(subSteps);
            Scene::AddBox(scene.Body(b2_staticBody, 0.0f, 0.0f), 0.1f, 5.0f);
            b2Body* front = scene.Box(-2.3f, 0.0f, 0.5f, 0.05f);
            b2Body* back = scene.Box(-3.3f, 0.0f, 0.5f, 0.05f);
            b2RevoluteJointDef hinge;
            hinge.Initialize(front, back, b2Vec2(-2.8f, 0.0f));
            scene.world.CreateJoint(&hinge);
            front->SetLinearVelocity(b2Vec2(60.0f, 0.0f));
            back->SetLinearVelocity(b2Vec2(60.0f, 0.0f));
            Lullaby listener;
            listener.body = back;
            listener.when = when;
            scene.world.SetContactListener(&listener);
            for (int step = 0; step < 60; ++step)
            {
                scene.Step();
            }
            EXPECT_GT(listener.calls, 0) << when;
            EXPECT_LT(front->GetPosition().x, -0.5f) << subSteps << " sub-steps, " << when;
            EXPECT_LT(back->GetPosition().x, -0.5f) << subSteps << " sub-steps, " << when;
        }
    }
}

} // namespace
