// SPDX-License-Identifier: MIT
#include "../base/ReadBytes.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

/// b2World::Dump writes code that makes the world again. The code is stored in DumpedWorld.inc and
/// compiled into this test. After an intended change of the text, the failing test prints the path
/// of the new one.
namespace
{

using dynamics::Scene;

/// A bit of everything that a dump has to carry over.
void Build(Scene& scene)
{
    b2Body* ground = scene.Ground();
    b2Body* lopsided = scene.Body(b2_dynamicBody, -3.0f, 2.0f, 0.4f);
    b2PolygonShape beam;
    beam.SetAsBox(1.0f, 0.25f, b2Vec2(0.75f, 0.0f), 0.0f);
    Scene::Add(lopsided, beam, 0.7f, 0.1f);
    lopsided->SetLinearVelocity(b2Vec2(1.0f, 2.0f));
    lopsided->SetAngularVelocity(3.0f);
    lopsided->SetLinearDamping(0.125f);
    b2Body* ball = scene.Ball(1.0f, 3.0f, 0.4f);
    ball->SetGravityScale(0.5f);
    b2Body* weighted = scene.Box(4.0f, 1.0f);
    b2MassData mass;
    mass.mass = 5.0f;
    mass.center.Set(0.125f, 0.25f);
    mass.I = 2.0f;
    weighted->SetMassData(&mass);
    b2Body* edge = scene.Body(b2_staticBody, 0.0f, 0.0f);
    const b2Vec2 corners[3] = {b2Vec2(-8.0f, 2.0f), b2Vec2(-6.0f, 0.0f), b2Vec2(6.0f, 0.0f)};
    b2ChainShape chain;
    chain.CreateChain(corners, 3);
    Scene::Add(edge, chain, 0.3f, 0.0f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(ground, lopsided, lopsided->GetPosition());
    hinge.enableMotor = true;
    hinge.motorSpeed = 1.0f;
    hinge.maxMotorTorque = 20.0f;
    scene.world.CreateJoint(&hinge);
    b2DistanceJointDef rod;
    rod.Initialize(ball, weighted, ball->GetPosition(), weighted->GetPosition());
    rod.frequencyHz = 2.0f;
    rod.dampingRatio = 0.25f;
    scene.world.CreateJoint(&rod);
}

std::string s_log;

void Collect(const char* text)
{
    s_log += text;
}

std::string Dumped(b2World& world)
{
    s_log.clear();
    b2SetLog(Collect);
    world.Dump();
    b2SetLog(nullptr);
    return s_log;
}

/// The world that the stored code makes.
std::unique_ptr<b2World> RunStored()
{
#include "DumpedWorld.inc"
    return std::unique_ptr<b2World>(m_world);
}

TEST(Dump, EqualsTheStoredCode)
{
    Scene scene;
    Build(scene);
    const std::string dumped = Dumped(scene.world);
    if (dumped != ReadBytes(BOXREEL_DUMPED_WORLD))
    {
        const std::string path = testing::TempDir() + "DumpedWorld.inc";
        std::ofstream(path) << dumped;
        ADD_FAILURE() << "the dump is in " << path;
    }
}

TEST(Dump, CreatesAWorldThatMovesAsTheDumpedOne)
{
    Scene original;
    Build(original);
    const std::unique_ptr<b2World> copy = RunStored();
    ASSERT_EQ(copy->GetBodyCount(), original.world.GetBodyCount());
    ASSERT_EQ(copy->GetJointCount(), original.world.GetJointCount());
    EXPECT_EQ(copy->GetGravity(), original.world.GetGravity());
    for (int step = 0; step <= 60; ++step)
    {
        const b2Body* b = copy->GetBodyList();
        for (const b2Body* a = original.world.GetBodyList(); a; a = a->GetNext(), b = b->GetNext())
        {
            EXPECT_FLOAT_EQ(a->GetMass(), b->GetMass());
            EXPECT_NEAR(b2Distance(a->GetPosition(), b->GetPosition()), 0.0f, 1e-4f) << step;
            EXPECT_NEAR(b2Distance(a->GetLinearVelocity(), b->GetLinearVelocity()), 0.0f, 2e-3f)
                << step;
            EXPECT_NEAR(a->GetAngle(), b->GetAngle(), 1e-4f) << step;
        }
        original.Step();
        copy->Step(dynamics::kStep, 8, 3);
    }
}

} // namespace
