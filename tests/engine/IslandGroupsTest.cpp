// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"
#include "SnapshotSupport.h"

#include <Dynamics/Solver/SolverMemory.h>
#include <Dynamics/State/Access.h>
#include <Dynamics/State/World.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <thread>

/// Large worlds of separate islands are solved part by part, with the result of all at once.
namespace
{

using namespace dynamics;
using namespace snapshots;
using box2d::Data;
using box2d::IslandGroup;

/// A kinematic body far away, which keeps all bodies in one group.
void AddMovingBody(b2World& world)
{
    b2BodyDef def;
    def.type = b2_kinematicBody;
    def.position.Set(0.0f, 1000.0f);
    def.linearVelocity.Set(0.0f, 1.0f);
    (void)world.CreateBody(&def);
}

/// Pyramids of boxes that balls hit, each an island.
class Pyramids
{
public:
    Pyramids(int subSteps, bool divided, int32 threads = 1, int count = 14)
    {
        scene.world.SetSubStepCount(subSteps);
        scene.world.SetThreadCount(threads);
        b2Body* ground = scene.Body(b2_staticBody, 0.0f, -1.0f);
        Scene::AddBox(ground, 20.0f * float32(count), 1.0f);
        for (int i = 0; i < count; ++i)
        {
            Build(20.0f * float32(i - count / 2));
        }
        if (!divided)
        {
            AddMovingBody(scene.world);
        }
    }

    void Build(float32 x)
    {
        for (int row = 0; row < 12; ++row)
        {
            for (int i = 0; i < 12 - row; ++i)
            {
                bodies.push_back(
                    scene.Box(x + 1.05f * (float32(i) + 0.5f * float32(row)),
                              0.5f + kRestingGap + (1.0f + kRestingGap) * float32(row)));
            }
        }
        b2Body* ball = scene.Ball(x + 4.0f, 14.0f);
        ball->SetLinearVelocity(b2Vec2(0.01f * x, -20.0f));
        bodies.push_back(ball);
    }

    const box2d::SolverMemory& Solver() const { return *Data(*bodies.back()).world->solver; }
    int32 Groups() const { return Solver().groups.Count(); }

    void ExpectSameAs(const Pyramids& other) const
    {
        for (std::size_t i = 0; i < bodies.size(); ++i)
        {
            const b2Body& a = *bodies[i];
            const b2Body& b = *other.bodies[i];
            ASSERT_EQ(a.GetPosition(), b.GetPosition()) << i;
            ASSERT_EQ(a.GetAngle(), b.GetAngle()) << i;
            ASSERT_EQ(a.GetLinearVelocity(), b.GetLinearVelocity()) << i;
            ASSERT_EQ(a.GetAngularVelocity(), b.GetAngularVelocity()) << i;
            ASSERT_EQ(a.IsAwake(), b.IsAwake()) << i;
        }
    }

    Scene scene;
    std::vector<b2Body*> bodies;
};

/// Each of these changes the order of the awake bodies, or connects or divides islands.
void Change(Pyramids& pyramids, int step)
{
    std::vector<b2Body*>& bodies = pyramids.bodies;
    const std::size_t i = std::size_t(step) * 37 % bodies.size();
    switch (step % 6)
    {
    case 0:
        pyramids.scene.world.DestroyBody(bodies[i]);
        bodies.erase(bodies.begin() + std::ptrdiff_t(i));
        break;
    case 1:
        bodies[i]->SetAwake(false);
        break;
    case 2:
        bodies.push_back(pyramids.scene.Box(float32(step) - 40.0f, 16.0f, 9.0f, 0.2f));
        break;
    case 3:
        bodies[i]->SetTransform(bodies[i / 2]->GetPosition() + b2Vec2(0.3f, 0.3f), 0.1f);
        break;
    case 4:
        bodies[i]->SetActive(!bodies[i]->IsActive());
        break;
    default:
        bodies[i]->SetType(b2_staticBody);
    }
}

/// Expects that no block of contacts reaches beyond its group. Returns the number of contacts.
std::size_t ExpectDivided(const box2d::SolverMemory& solver)
{
    int32 last = 0;
    std::size_t contacts = 0;
    for (int32 i = 0; i < solver.groups.Count(); ++i)
    {
        const IslandGroup group = solver.groups.At(i);
        EXPECT_EQ(group.firstBody, last);
        last = group.endBody;
        const auto isOutside = [&](int32 body) {
            return body != 0 && (body <= group.firstBody || body > group.endBody);
        };
        for (int32 k = 0; k < solver.colorCount; ++k)
        {
            const box2d::ContactBlocks& blocks = solver.contacts[solver.colors[k]];
            const box2d::BlockRange range = blocks.Of(group);
            for (int32 n = range.begin; n < range.end; ++n)
            {
                const box2d::ContactBlock& block = blocks.Contacts(n);
                contacts += std::size_t(block.count);
                EXPECT_TRUE(std::none_of(block.bodyA, block.bodyA + block.count, isOutside));
                EXPECT_TRUE(std::none_of(block.bodyB, block.bodyB + block.count, isOutside));
            }
        }
    }
    return contacts;
}

class IslandGroups : public testing::TestWithParam<int>
{};

INSTANTIATE_TEST_SUITE_P(SubSteps, IslandGroups, testing::Values(1, 2, 4));

TEST_P(IslandGroups, DivideBodiesAndTheirContacts)
{
    Pyramids pyramids(GetParam(), true);
    int32 most = 1;
    for (int step = 0; step < 60 && !HasFailure(); ++step)
    {
        Change(pyramids, step);
        pyramids.scene.Step(2);
        if (pyramids.Groups() > 1)
        {
            EXPECT_GT(ExpectDivided(pyramids.Solver()), 1000u);
            most = b2Max(most, pyramids.Groups());
        }
    }
    EXPECT_GE(most, 2);
}

/// With one iteration of positions: groups that are apart would need no second. With sub-steps bits
/// are the same only where no island is solved directly or again after it has gained energy.
TEST(IslandGroupsInOneStep, GiveTheBitsOfAllBodiesTogether)
{
    Pyramids divided(1, true);
    Pyramids whole(1, false);
    int32 most = 1;
    for (int step = 0; step < 100 && !HasFailure(); ++step)
    {
        divided.scene.world.Step(kStep, 8, 1);
        whole.scene.world.Step(kStep, 8, 1);
        divided.ExpectSameAs(whole);
        EXPECT_EQ(whole.Groups(), 1);
        most = b2Max(most, divided.Groups());
    }
    EXPECT_GE(most, 2);
}

/// The last body takes the place of the first one and comes into another group, while no contact
/// and no size of a group changes.
TEST_P(IslandGroups, FollowTheOrderOfBodiesAlone)
{
    Scene scene;
    scene.world.SetSubStepCount(GetParam());
    scene.world.SetAllowSleeping(false);
    scene.Ground();
    b2Body* first = scene.Ball(0.0f, 100.0f);
    std::vector<b2Body*> boxes;
    for (int i = 0; i < 1100; ++i)
    {
        boxes.push_back(scene.Box(0.09f * float32(i) - 49.5f, 0.04f, 0.03f, 0.03f));
    }
    scene.Step(5);
    const box2d::World& world = *Data(*first).world;
    EXPECT_EQ(world.solver->groups.Count(), 3);
    scene.world.DestroyBody(first);
    (void)scene.Ball(0.0f, 100.0f);
    scene.Step();
    EXPECT_EQ(Data(*boxes.back()).awakeIndex, 0);
    EXPECT_EQ(world.solver->groups.Count(), 3);
    EXPECT_EQ(ExpectDivided(*world.solver), boxes.size());
}

/// Boxes that were created in turn, here and there, under plates that hold them together and have
/// more contacts than there are colours.
TEST_P(IslandGroups, SortBodiesThatWereCreatedInTurn)
{
    Scene scene;
    scene.world.SetSubStepCount(GetParam());
    scene.world.SetAllowSleeping(false);
    scene.Ground();
    std::vector<b2Body*> bodies;
    for (int i = 0; i < 1200; ++i) // in rows of six on each other
    {
        const float32 x = i % 2 == 0 ? -40.0f : 1.0f;
        const int place = i / 2;
        bodies.push_back(scene.Box(x + 0.32f * float32(place / 6),
                                   0.16f + 0.31f * float32(place % 6), 0.15f, 0.15f));
    }
    for (int i = 0; i < 2; ++i)
    {
        bodies.push_back(scene.Box(-24.0f + 41.0f * float32(i), 2.1f, 16.0f, 0.1f));
    }
    const box2d::World& world = *Data(*bodies.front()).world;
    scene.Step(30);
    EXPECT_EQ(world.solver->groups.Count(), 2);
    EXPECT_GT(ExpectDivided(*world.solver), 1200u);
    for (std::size_t i = 0; i < world.awakeBodies.size(); ++i)
    {
        EXPECT_EQ(Data(*world.awakeBodies[i]).awakeIndex, int32(i));
    }
    Scene restored;
    ExpectRestored(restored.world, b2SaveSnapshot(scene.world));
    ExpectSameWay(scene.world, restored.world, Steps{.count = 5});
}

TEST_P(IslandGroups, GiveTheSameBitsWithEveryNumberOfThreads)
{
    Pyramids one(GetParam(), true, 1, 30);
    Pyramids two(GetParam(), true, 2, 30);
    Pyramids five(GetParam(), true, 5, 30);
    int32 most = 1;
    for (int step = 0; step < 12 && !HasFailure(); ++step)
    {
        for (Pyramids* pyramids : {&one, &two, &five})
        {
            Change(*pyramids, step);
            pyramids->scene.Step(3);
        }
        EXPECT_EQ(two.Groups(), one.Groups());
        two.ExpectSameAs(one);
        five.ExpectSameAs(one);
        most = b2Max(most, one.Groups());
    }
    EXPECT_GE(most, 3);
}

std::thread::id g_caller;
std::atomic<int> g_strangers{0};

void* AllocateHere(std::size_t size)
{
    g_strangers += std::this_thread::get_id() != g_caller;
    return std::malloc(size > 0 ? size : 1);
}

/// Leaning stacks, each small enough to be solved directly by a system that is built for it.
TEST_P(IslandGroups, AllocateNothingOnOtherThreads)
{
    g_caller = std::this_thread::get_id();
    g_strangers = 0;
    b2SetAllocator(AllocateHere, std::free);
    {
        Scene scene;
        scene.world.SetSubStepCount(GetParam());
        scene.world.SetThreadCount(3);
        scene.world.SetAllowSleeping(false);
        b2Body* ground = scene.Body(b2_staticBody, 0.0f, -1.0f);
        Scene::AddBox(ground, 1000.0f, 1.0f);
        for (int i = 0; i < 1200; ++i)
        {
            const auto row = float32(i % 8);
            b2Body* box = scene.Box(6.0f * float32(i / 8) - 450.0f + 0.05f * row * float32(i % 3),
                                    0.52f + 1.02f * row);
            box->GetFixtureList()->SetDensity(1.0f + float32(i % 8) * float32(i % 5));
            box->ResetMassData();
        }
        scene.Step(60);
        EXPECT_GE(Data(*ground).world->solver->groups.Count(), 2);
    }
    b2SetAllocator(nullptr, nullptr);
    EXPECT_EQ(g_strangers, 0);
}

TEST_P(IslandGroups, GoOnFromASnapshotBitByBit)
{
    for (const int step : {1, 20, 40})
    {
        Pyramids saved(GetParam(), true);
        saved.scene.Step(step);
        EXPECT_GE(saved.Groups(), 2);
        Scene restored;
        ExpectRestored(restored.world, b2SaveSnapshot(saved.scene.world));
        ExpectSameWay(saved.scene.world, restored.world, Steps{.count = 30},
                      [&](b2World& world, int next) {
                          if (step == 40 && next == 0) // then there is one group
                          {
                              AddMovingBody(world);
                          }
                      });
    }
}

} // namespace
