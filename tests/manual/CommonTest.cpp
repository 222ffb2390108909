// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <Box2D/Common/b2StackAllocator.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

/// The introduction's and the Common module's chapters, section by section; the settings have a
/// file of their own.
namespace
{

using dynamics::Scene;

int allocations = 0;
int releases = 0;

void* CountingAlloc(std::size_t size)
{
    ++allocations;
    return std::malloc(size);
}

void CountingFree(void* memory)
{
    ++releases;
    std::free(memory);
}

/// Puts counting functions behind b2Alloc and b2Free for its lifetime.
struct CountedMemory
{
    CountedMemory()
    {
        allocations = 0;
        releases = 0;
        b2SetAllocator(CountingAlloc, CountingFree);
    }
    ~CountedMemory() { b2SetAllocator(nullptr, nullptr); }
};

TEST(CoreConcepts, AllowSeveralWorldsAtOnce)
{
    Scene first(b2Vec2(0.0f, -10.0f));
    Scene second(b2Vec2(0.0f, 10.0f));
    b2Body* falling = first.Box(0.0f, 0.0f);
    b2Body* rising = second.Box(0.0f, 0.0f);
    first.Step(10);
    second.Step(10);
    EXPECT_LT(falling->GetPosition().y, 0.0f);
    EXPECT_EQ(rising->GetPosition().y, -falling->GetPosition().y);
}

TEST(Units, LetAnAngleGrowUntilItIsSet)
{
    Scene scene(b2Vec2_zero);
    b2Body* body = scene.Box(0.0f, 0.0f);
    body->SetAngularVelocity(10.0f);
    scene.Step(600);
    EXPECT_NEAR(body->GetAngle(), 100.0f, 0.01f);
    const b2Vec2 axis = body->GetWorldVector(b2Vec2(1.0f, 0.0f));
    body->SetAngle(std::fmod(body->GetAngle(), 2.0f * b2_pi));
    EXPECT_LT(body->GetAngle(), 2.0f * b2_pi);
    EXPECT_NEAR(b2Distance(axis, body->GetWorldVector(b2Vec2(1.0f, 0.0f))), 0.0f, 1e-4f);
}

TEST(FactoriesAndDefinitions, CopyDefinitionsAndShapes)
{
    b2World world(b2Vec2_zero);
    b2Body* body = nullptr;
    {
        b2BodyDef def;
        def.position.Set(1.0f, 2.0f);
        body = world.CreateBody(&def);
        b2CircleShape circle;
        circle.m_radius = 0.5f;
        body->CreateFixture(&circle, 1.0f);
        def.position.Set(7.0f, 7.0f);
        circle.m_radius = 7.0f;
    }
    EXPECT_EQ(body->GetPosition(), b2Vec2(1.0f, 2.0f));
    EXPECT_EQ(body->GetFixtureList()->GetShape()->m_radius, 0.5f);
}

TEST(AllocationWrappers, UseTheMemorySystemOfTheProgram)
{
    const CountedMemory counted;
    {
        Scene scene;
        scene.Ground();
        scene.Box(0.0f, 3.0f);
        scene.Step(10);
        EXPECT_GT(allocations, releases);
    }
    EXPECT_GT(allocations, 0);
    EXPECT_EQ(allocations, releases);

    void* memory = b2Alloc(100);
    EXPECT_NE(memory, nullptr);
    b2Free(memory);
    EXPECT_EQ(allocations, releases);
}

TEST(MemoryManagement, PutsSmallObjectsIntoFewLargeBlocks)
{
    const CountedMemory counted;
    {
        b2BlockAllocator allocator;
        for (int i = 0; i < 40; ++i)
        {
            EXPECT_NE(allocator.Allocate(50 + 5 * (i % 2)), nullptr);
        }
        EXPECT_LE(allocations, 2);
    }
    EXPECT_EQ(allocations, releases);
}

TEST(MemoryManagement, ReusesAFreedBlock)
{
    b2BlockAllocator allocator;
    void* first = allocator.Allocate(300);
    allocator.Free(first, 300);
    EXPECT_EQ(allocator.Allocate(300), first);
}

TEST(MemoryManagement, AllocatesNothingInASteadyStep)
{
    for (const int32 threads : {1, 3})
    {
        const CountedMemory counted;
        Scene scene;
        scene.world.SetThreadCount(threads);
        scene.world.SetAllowSleeping(false);
        b2Body* ground = scene.Ground();
        scene.Wall(-30.0f);
        scene.Wall(30.0f);
        for (int i = 0; i < 20; ++i)
        {
            dynamics::Stack(scene, 2.0f * float32(i), 6);
        }
        b2Body* last = ground; // a chain that swings
        for (int i = 0; i < 10; ++i)
        {
            b2Body* link = scene.Box(-10.5f - float32(i), 15.0f, 0.5f, 0.1f);
            b2RevoluteJointDef hinge;
            hinge.Initialize(last, link, b2Vec2(-10.0f - float32(i), 15.0f));
            scene.world.CreateJoint(&hinge);
            last = link;
        }
        b2Body* bullet = scene.Ball(-20.0f, 1.0f, 0.2f); // one impact after the other
        bullet->SetBullet(true);
        bullet->SetGravityScale(0.0f);
        bullet->GetFixtureList()->SetRestitution(1.0f);
        bullet->GetFixtureList()->SetFriction(0.0f);
        bullet->SetLinearVelocity(b2Vec2(0.0f, -200.0f));
        b2Body* ceiling = scene.Body(b2_staticBody, -20.0f, 3.0f);
        Scene::AddBox(ceiling, 1.0f, 0.1f);
        scene.Step(200);
        const int before = allocations;
        scene.Step(100);
        EXPECT_EQ(allocations, before) << threads << " threads";
    }
}

TEST(MemoryManagement, TakesStackMemoryFromOneBuffer)
{
    const CountedMemory counted;
    b2StackAllocator allocator;
    for (int round = 0; round < 5; ++round)
    {
        void* below = allocator.Allocate(1000);
        void* above = allocator.Allocate(2000);
        std::memset(below, 1, 1000);
        std::memset(above, 2, 2000);
        EXPECT_EQ(static_cast<char*>(below)[999], 1);
        allocator.Free(above);
        allocator.Free(below);
    }
    EXPECT_LE(allocations, 1);
    EXPECT_GE(allocator.GetMaxAllocation(), 3000);
}

TEST(Math, OffersVectorsAndMatricesToPrograms)
{
    const b2Vec2 v(3.0f, 4.0f);
    EXPECT_EQ(v.Length(), 5.0f);
    EXPECT_EQ(b2Dot(v, v.Skew()), 0.0f);
    const b2Mat22 matrix(2.0f, 1.0f, 1.0f, 3.0f);
    const b2Vec2 product = b2Mul(matrix, matrix.Solve(v));
    EXPECT_NEAR(b2Distance(product, v), 0.0f, 1e-5f);
    b2Mat33 larger(b2Vec3(2.0f, 0.0f, 1.0f), b2Vec3(0.0f, 4.0f, 0.0f), b2Vec3(1.0f, 0.0f, 3.0f));
    const b2Vec3 solution = larger.Solve33(b2Vec3(5.0f, 8.0f, 10.0f));
    EXPECT_NEAR(solution.x, 1.0f, 1e-5f);
    EXPECT_NEAR(solution.y, 2.0f, 1e-5f);
    EXPECT_NEAR(solution.z, 3.0f, 1e-5f);
}

TEST(Math, TransformsPointsToAFrameAndBack)
{
    b2Transform frame;
    frame.Set(b2Vec2(1.0f, 2.0f), 0.5f * b2_pi);
    const b2Vec2 world = b2Mul(frame, b2Vec2(1.0f, 0.0f));
    EXPECT_NEAR(b2Distance(world, b2Vec2(1.0f, 3.0f)), 0.0f, 1e-6f);
    EXPECT_NEAR(b2Distance(b2MulT(frame, world), b2Vec2(1.0f, 0.0f)), 0.0f, 1e-6f);
}

} // namespace
