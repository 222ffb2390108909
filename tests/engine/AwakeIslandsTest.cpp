// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Dynamics/Solver/SolverMemory.h>
#include <Dynamics/State/Access.h>
#include <Dynamics/State/World.h>
#include <Dynamics/SubSteps/SubStepMemory.h>

#include <gtest/gtest.h>

/// The work of a step with sub-steps does not grow with the number of sleeping bodies.
namespace
{

using namespace dynamics;

/// Boxes side by side on the ground, each an island.
struct Row
{
    explicit Row(int count, int subSteps = 2)
    {
        scene.world.SetSubStepCount(subSteps);
        scene.Ground();
        for (int i = 0; i < count; ++i)
        {
            boxes.push_back(scene.Box(2.0f * float32(i) - float32(count), 0.51f));
        }
    }

    box2d::World& World() { return *box2d::Data(*boxes.front()).world; }
    void ExpectLookedAt(std::size_t count)
    {
        EXPECT_EQ(std::size_t(World().solver->islands.Count()), count);
        EXPECT_EQ(World().subSteps->contacts.Count(), count);
        EXPECT_EQ(World().subSteps->warmStartGuard.Count(), count);
    }

    Scene scene;
    std::vector<b2Body*> boxes;
};

TEST(AwakeIslands, AreTheOnlyOnesThatAStepProcesses)
{
    for (const int subSteps : {2, 4})
    {
        Row row(40, subSteps);
        row.boxes[30]->SetSleepingAllowed(false);
        row.scene.Step();
        row.ExpectLookedAt(40);
        row.scene.Step(200);
        ASSERT_FALSE(row.boxes[0]->IsAwake());
        row.ExpectLookedAt(1);
    }
}

TEST(AwakeIslands, AreProcessedAgainWhenTheyWake)
{
    Row row(10);
    row.boxes[3]->SetSleepingAllowed(false);
    row.scene.Step(200);
    row.ExpectLookedAt(1);
    row.boxes[7]->ApplyLinearImpulse(b2Vec2(1.0f, 0.0f), row.boxes[7]->GetWorldCenter(), true);
    row.scene.Step();
    row.ExpectLookedAt(2);
    row.scene.Step(300);
    row.ExpectLookedAt(1);
}

TEST(AwakeIslands, AreNotCountedWithoutConstraints)
{
    Row row(1);
    row.boxes[0]->SetTransform(b2Vec2(0.0f, 50.0f), 0.0f);
    row.scene.Step();
    row.ExpectLookedAt(0);
    row.boxes[0]->SetTransform(b2Vec2(0.0f, 0.51f), 0.0f);
    row.scene.Step(3);
    row.ExpectLookedAt(1);
    row.boxes[0]->SetTransform(b2Vec2(0.0f, 50.0f), 0.0f);
    row.scene.Step(2);
    EXPECT_EQ(row.World().subSteps->contacts.Count(), 0u);
}

TEST(AwakeIslands, AreNumberedFromZero)
{
    Row row(5);
    row.boxes[1]->SetAwake(false);
    row.boxes[2]->SetAwake(false);
    const box2d::World& world = *box2d::Data(*row.boxes[0]).world;
    box2d::AwakeIslands islands;
    for (const int awake : {3, 4})
    {
        islands.Find(world);
        EXPECT_EQ(islands.Count(), awake);
        std::vector<bool> seen(std::size_t(awake), false);
        for (const b2Body* box : row.boxes)
        {
            const box2d::BodyData& data = box2d::Data(*box);
            const int32 number = islands.NumberOf(data.island);
            EXPECT_EQ(number != -1, box->IsAwake());
            if (number != -1)
            {
                ASSERT_LT(number, awake);
                EXPECT_FALSE(seen[std::size_t(number)]);
                seen[std::size_t(number)] = true;
                EXPECT_EQ(islands.At(number), data.island);
                EXPECT_EQ(islands.Of(data.SolverIndex()), number);
            }
        }
        row.boxes[2]->SetAwake(true);
    }
    EXPECT_EQ(islands.Of(0), -1) << "what never moves";
    EXPECT_EQ(islands.NumberOf(-1), -1);
    EXPECT_EQ(islands.NumberOf(1000000), -1) << "an island that has come since";
}

} // namespace
