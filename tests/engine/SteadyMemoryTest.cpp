// SPDX-License-Identifier: MIT
#include "SubStepsScene.h"

#include <atomic>
#include <cstdlib>
#include <new>

/// A world in steady state allocates no memory, with any number of sub-steps. The allocations are
/// those of b2Alloc and of operator new, which this program replaces to count them.
namespace
{

std::atomic<int> requests{0};

void* Count(std::size_t size)
{
    ++requests;
    return std::malloc(size > 0 ? size : 1);
}

} // namespace

// Not inlined, or a compiler that sees only one of a pair takes free for the wrong counterpart.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    if (void* memory = Count(size))
    {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    return Count(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept
{
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept
{
    std::free(memory);
}

namespace
{

using namespace dynamics;

/// Counts the calls of b2Alloc during its lifetime.
struct CountedMemory
{
    CountedMemory() { b2SetAllocator(Count, std::free); }
    ~CountedMemory() { b2SetAllocator(nullptr, nullptr); }
};

/// Boxes whose weights differ by so much that sweeps leave something to solve.
void Piles(SmallScene& s)
{
    s.Ground();
    for (int i = 0; i < 4; ++i)
    {
        Stack(s, -6.0f + 4.0f * float32(i), 3 + 2 * i)
            .back()
            ->GetFixtureList()
            ->SetDensity(20.0f * float32(i + 1));
    }
    for (b2Body* body = s.world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        body->ResetMassData();
    }
    for (int row = 0; row < 6; ++row)
    {
        for (int i = 0; i < 6 - row; ++i)
        {
            s.Box(12.0f + 1.1f * float32(i) + 0.55f * float32(row), 0.5f + float32(row));
        }
    }
}

/// The balls are a hundred times as heavy as a link. One hangs freely, the other is on the ground.
/// Air slows them down, because a chain that swings for ever may touch itself in new places.
void ChainsWithBalls(SmallScene& s)
{
    s.Ground();
    for (const float32 height : {12.0f, 5.0f})
    {
        b2Body* last = s.Post(0.0f, height);
        for (int i = 0; i < 8; ++i)
        {
            b2Body* link = s.Load(float32(i) + 0.5f, height, 0.5f, 0.1f);
            s.Hinge(last, link, float32(i), height);
            link->SetLinearDamping(0.3f);
            last = link;
        }
        b2Body* ball = s.Ball(8.0f, height);
        ball->GetFixtureList()->SetDensity(25.0f);
        ball->ResetMassData();
        ball->SetLinearDamping(0.3f);
        s.Hinge(last, ball, 8.0f, height);
    }
}

/// Planks between two banks, each held at two heights, with boxes on them.
/// Air slows the planks down. A taut bridge without it swings for minutes, until a box slides off.
void LoopsOfABridge(SmallScene& s)
{
    b2Body* bank = s.Post();
    b2Body* last = bank;
    for (int i = 0; i < 12; ++i)
    {
        b2Body* plank = s.Load(float32(i) + 0.5f, 0.0f, 0.5f, 0.1f);
        s.Hinge(last, plank, float32(i), 0.0f);
        plank->SetLinearDamping(0.3f);
        last = plank;
    }
    s.Hinge(last, bank, 12.0f, 0.0f);
    for (int i = 0; i < 4; ++i)
    {
        s.Box(2.0f + 2.5f * float32(i), 1.0f, 0.4f, 0.4f);
    }
}

/// A torso, arms and legs with limits.
void Ragdoll(SmallScene& s, float32 x, float32 y)
{
    b2Body* torso = s.Load(x, y, 0.2f, 0.35f);
    const auto limb = [&](b2Body* from, float32 atX, float32 atY, float32 hx, float32 hy) {
        b2Body* body = s.Load(x + atX, y + atY, hx, hy);
        b2RevoluteJointDef def;
        def.Initialize(from, body,
                       b2Vec2(x + atX - (atX > 0.0f ? hx : -hx) * (hx > hy ? 1.0f : 0.0f),
                              y + atY + (hy > hx ? hy : 0.0f)));
        def.enableLimit = true;
        def.lowerAngle = -0.6f;
        def.upperAngle = 0.6f;
        s.world.CreateJoint(&def);
        return body;
    };
    for (const float32 side : {-1.0f, 1.0f})
    {
        b2Body* upper = limb(torso, 0.4f * side, 0.25f, 0.2f, 0.08f);
        limb(upper, 0.8f * side, 0.25f, 0.2f, 0.07f);
        b2Body* thigh = limb(torso, 0.12f * side, -0.57f, 0.09f, 0.22f);
        limb(thigh, 0.12f * side, -1.01f, 0.08f, 0.22f);
    }
}

void RagdollsOnTheGround(SmallScene& s)
{
    s.Ground();
    for (int i = 0; i < 4; ++i)
    {
        Ragdoll(s, 3.0f * float32(i), 1.5f);
    }
}

/// A motor turns a gear, that another, and a weight hangs from a pulley.
void MachineInMotion(SmallScene& s)
{
    b2Body* post = s.Post();
    b2Body* small = s.Part(0.0f, 0.0f, 0.3f, 0.3f);
    b2Body* large = s.Part(1.0f, 0.0f, 0.6f, 0.6f);
    b2Body* rack = s.Part(2.0f, 0.0f, 0.1f, 1.0f);
    b2RevoluteJoint* driven = s.Hinge(post, small, 0.0f, 0.0f);
    driven->EnableMotor(true);
    driven->SetMotorSpeed(2.0f);
    driven->SetMaxMotorTorque(1000.0f);
    b2GearJointDef gear;
    gear.joint1 = driven;
    gear.joint2 = s.Hinge(post, large, 1.0f, 0.0f);
    gear.ratio = 2.0f;
    gear.bodyA = small;
    gear.bodyB = large;
    s.world.CreateJoint(&gear);
    gear.joint1 = gear.joint2;
    gear.joint2 = s.Slider(post, rack, 2.0f, 0.0f, b2Vec2(0.0f, 1.0f));
    gear.bodyA = large;
    gear.bodyB = rack;
    s.world.CreateJoint(&gear);
    b2PulleyJointDef pulley;
    b2Body* left = s.Part(-4.0f, 0.0f, 0.3f, 0.3f);
    b2Body* right = s.Part(-2.0f, 0.0f, 0.3f, 0.3f);
    left->SetLinearVelocity(b2Vec2(0.5f, 0.0f));
    pulley.Initialize(left, right, b2Vec2(-4.0f, 3.0f), b2Vec2(-2.0f, 3.0f), b2Vec2(-4.0f, 0.3f),
                      b2Vec2(-2.0f, 0.3f), 1.0f);
    s.world.CreateJoint(&pulley);
}

/// Boxes and balls in a turning drum: contacts and islands come and go in every step.
void TurningDrum(SmallScene& s)
{
    b2Body* drum = s.Body(b2_kinematicBody, 0.0f, 0.0f);
    for (int i = 0; i < 4; ++i)
    {
        b2PolygonShape wall;
        const float32 angle = 0.5f * b2_pi * float32(i);
        wall.SetAsBox(0.2f, 4.0f, b2Vec2(4.0f * std::cos(angle), 4.0f * std::sin(angle)), angle);
        Scene::Add(drum, wall, 0.6f, 0.0f);
    }
    drum->SetAngularVelocity(0.8f);
    for (int i = 0; i < 24; ++i)
    {
        const float32 x = -2.5f + float32(i % 6);
        const float32 y = -2.0f + float32(i / 6);
        i % 3 == 0 ? s.Ball(x, y, 0.3f) : s.Box(x, y, 0.3f, 0.25f);
    }
}

/// A ball thrown to and fro between two plates, one impact within a step after the other.
void BulletBetweenPlates(SmallScene& s)
{
    s.world.SetContinuousPhysics(true);
    s.Ground();
    Scene::AddBox(s.Body(b2_staticBody, 0.0f, 3.0f), 1.0f, 0.1f);
    b2Body* bullet = s.Ball(0.0f, 1.0f, 0.2f);
    bullet->SetBullet(true);
    bullet->SetGravityScale(0.0f);
    bullet->GetFixtureList()->SetRestitution(1.0f);
    bullet->GetFixtureList()->SetFriction(0.0f);
    bullet->SetLinearVelocity(b2Vec2(0.0f, -200.0f));
}

void ExpectNoRequests(void (*fill)(SmallScene&))
{
    for (const int32 threads : {1, 3})
    {
        for (const int32 subSteps : {1, 2, 4})
        {
            const CountedMemory counted;
            SmallScene s(b2Vec2(0.0f, -kGravity), subSteps);
            s.world.SetThreadCount(threads);
            s.world.SetAllowSleeping(false);
            fill(s);
            s.Step(900);
            const int before = requests;
            s.Step(120);
            EXPECT_EQ(requests - before, 0) << threads << " threads, " << subSteps << " sub-steps";
        }
    }
}

/// Chains of ten boxes, hinged (with limits or without), welded or sliding on springs.
void SleepyChains(SmallScene& s)
{
    s.Ground();
    for (int kind = 0; kind < 4; ++kind)
    {
        const float32 x = 12.0f * float32(kind);
        b2Body* last = nullptr;
        for (int i = 0; i < 10; ++i)
        {
            const float32 at = x + 0.8f * float32(i);
            b2Body* link = s.Box(at, 0.22f, 0.3f, 0.2f);
            const b2Vec2 between(at - 0.4f, 0.22f);
            if (last != nullptr && kind == 0)
            {
                s.Weld(last, link, between.x, between.y);
            }
            else if (last != nullptr && kind == 1)
            {
                b2WheelJointDef def;
                def.Initialize(last, link, between, b2Vec2(0.0f, 1.0f));
                def.frequencyHz = 4.0f;
                def.dampingRatio = 1.0f;
                s.world.CreateJoint(&def);
            }
            else if (last != nullptr)
            {
                b2RevoluteJointDef def;
                def.Initialize(last, link, between);
                def.enableLimit = kind == 2;
                def.lowerAngle = -0.3f;
                def.upperAngle = 0.3f;
                s.world.CreateJoint(&def);
            }
            last = link;
        }
    }
    Stack(s, -5.0f, 10);
}

/// Whose bodies are woken by turns, every one a little differently, and fall asleep again.
TEST(SteadyMemory, IsEnoughForBodiesThatSleepAndWake)
{
    for (const int32 subSteps : {1, 2, 4})
    {
        const CountedMemory counted;
        SmallScene s(b2Vec2(0.0f, -kGravity), subSteps);
        SleepyChains(s);
        int asleep = 0;
        const auto wakeAndRest = [&](int cycles) {
            for (int cycle = 0; cycle < cycles; ++cycle)
            {
                for (b2Body* body = s.world.GetBodyList(); body; body = body->GetNext())
                {
                    const b2Vec2 push(0.0f, 0.02f * float32(cycle % 3) * body->GetMass());
                    body->ApplyLinearImpulse(push, body->GetWorldCenter(), true);
                }
                s.Step(240);
            }
            for (b2Body* body = s.world.GetBodyList(); body; body = body->GetNext())
            {
                asleep += !body->IsAwake();
            }
        };
        wakeAndRest(9);
        EXPECT_GE(asleep, 50) << "that they sleep is the point, " << subSteps << " sub-steps";
        const int before = requests;
        wakeAndRest(6);
        EXPECT_EQ(requests - before, 0) << subSteps << " sub-steps";
    }
}

TEST(SteadyMemory, CountsAllocationsOfAllKinds)
{
    const CountedMemory counted;
    const int before = requests;
    b2Free(b2Alloc(10));
    EXPECT_EQ(requests, before + 1);
    ::operator delete(::operator new(10));
    ::operator delete(::operator new(10, std::nothrow), std::nothrow);
    EXPECT_EQ(requests, before + 3);
}

TEST(SteadyMemory, IsEnoughForStacksAtRest)
{
    ExpectNoRequests(Piles);
}

TEST(SteadyMemory, IsEnoughForChainsWithBalls)
{
    ExpectNoRequests(ChainsWithBalls);
}

TEST(SteadyMemory, IsEnoughForLoopsOfABridge)
{
    ExpectNoRequests(LoopsOfABridge);
}

TEST(SteadyMemory, IsEnoughForRagdollsOnTheGround)
{
    ExpectNoRequests(RagdollsOnTheGround);
}

TEST(SteadyMemory, IsEnoughForAMachineInMotion)
{
    ExpectNoRequests(MachineInMotion);
}

TEST(SteadyMemory, IsEnoughForATurningDrum)
{
    ExpectNoRequests(TurningDrum);
}

TEST(SteadyMemory, IsEnoughForABulletBetweenPlates)
{
    ExpectNoRequests(BulletBetweenPlates);
}

} // namespace
