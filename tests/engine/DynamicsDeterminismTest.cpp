// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cstring>

/// The same calls give the same bits.
namespace
{

using namespace dynamics;

/// FNV-1a over the places, angles and velocities of all bodies.
class StateHash
{
public:
    explicit StateHash(const b2World& world)
    {
        for (const b2Body* b = world.GetBodyList(); b; b = b->GetNext())
        {
            for (const float32 value :
                 {b->GetPosition().x, b->GetPosition().y, b->GetAngle(), b->GetLinearVelocity().x,
                  b->GetLinearVelocity().y, b->GetAngularVelocity()})
            {
                Add(value);
            }
        }
    }
    std::uint64_t Value() const { return m_hash; }

private:
    void Add(float32 value)
    {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        for (int i = 0; i < 4; ++i)
        {
            m_hash = (m_hash ^ ((bits >> (8 * i)) & 0xFFu)) * 0x100000001B3ull;
        }
    }
    std::uint64_t m_hash = 0xCBF29CE484222325ull;
};

/// Piles, a chain, springs, bullets, a motor, a moving platform, things created and destroyed.
std::uint64_t RunScene(bool otherMemory, int32 subSteps)
{
    std::vector<Scene*> neighbours; // so that the world's memory lies elsewhere
    for (int i = 0; otherMemory && i < 5; ++i)
    {
        neighbours.push_back(new Scene);
        Stack(*neighbours.back(), 0.0f, 7 * i);
    }
    Scene scene;
    scene.world.SetSubStepCount(subSteps);
    b2Body* ground = scene.Ground();
    for (int i = 0; i < 6; ++i)
    {
        Stack(scene, -6.0f + 1.05f * float32(i), 6 - i);
    }
    b2Body* last = ground;
    for (int i = 0; i < 8; ++i)
    {
        b2Body* link = scene.Box(4.5f + float32(i), 6.0f, 0.5f, 0.1f);
        b2RevoluteJointDef def;
        def.Initialize(last, link, b2Vec2(4.0f + float32(i), 6.0f));
        scene.world.CreateJoint(&def);
        last = link;
    }
    b2Body* platform = scene.Body(b2_kinematicBody, 15.0f, 1.0f);
    Scene::AddBox(platform, 2.0f, 0.2f);
    platform->SetLinearVelocity(b2Vec2(-0.5f, 0.0f));
    platform->SetAngularVelocity(0.3f);
    b2Body* doomed = nullptr;
    for (int step = 0; step < 600; ++step)
    {
        if (step % 40 == 0)
        {
            b2Body* ball = scene.Ball(-20.0f, 1.0f + 0.01f * float32(step), 0.2f);
            ball->SetBullet(step % 80 == 0);
            ball->SetLinearVelocity(b2Vec2(60.0f, 2.0f));
            if (doomed)
            {
                scene.world.DestroyBody(doomed);
            }
            doomed = step % 120 == 0 ? ball : nullptr;
        }
        scene.Step();
    }
    for (Scene* neighbour : neighbours)
    {
        delete neighbour;
    }
    return StateHash(scene.world).Value();
}

TEST(DynamicsDeterminism, GivesTheSameBitsAtOtherAddresses)
{
    for (const int32 subSteps : {1, 4})
    {
        const std::uint64_t first = RunScene(false, subSteps);
        EXPECT_EQ(RunScene(false, subSteps), first);
        EXPECT_EQ(RunScene(true, subSteps), first);
        RecordProperty("hash_" + std::to_string(subSteps), std::to_string(first));
    }
}

// The hash of another build. A change of what sub-steps compute changes it.
TEST(DynamicsDeterminism, GivesTheBitsOfEveryCompiler)
{
    EXPECT_EQ(RunScene(false, 4), 1136703059264971818ull);
}

} // namespace
