// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

TEST(IntroductionListing, CreatesAndDestroysBodyFixtureAndJoint)
{
    b2World world(b2Vec2(0.0f, -10.0f));

    // [life]
    // A definition is filled in, read once, and may then be changed and used again.
    b2BodyDef bodyDef;
    b2Body* wall = world.CreateBody(&bodyDef); // static, at the origin: the defaults
    bodyDef.type = b2_dynamicBody;
    bodyDef.position.Set(2.0f, 0.0f);
    b2Body* arm = world.CreateBody(&bodyDef);

    b2PolygonShape box;
    box.SetAsBox(1.0f, 0.1f); // half the width and half the height
    b2Fixture* fixture = arm->CreateFixture(&box, 1.0f);

    b2RevoluteJointDef hingeDef;
    hingeDef.Initialize(wall, arm, b2Vec2(1.0f, 0.0f));
    b2Joint* hinge = world.CreateJoint(&hingeDef);

    // What is not destroyed by hand goes with its owner: fixtures and joints
    // with their body, everything with the world.
    world.DestroyJoint(hinge);
    arm->DestroyFixture(fixture);
    world.DestroyBody(arm);
    // [/life]

    EXPECT_EQ(world.GetBodyCount(), 1);
    EXPECT_EQ(world.GetJointCount(), 0);
}

/// Ten balls that fall on each other, as they lie after ten seconds.
std::string Heap(int32 threads)
{
    manual::Stage stage;
    // [same-bits]
    stage.world.SetThreadCount(threads); // 1 unless said
    // [/same-bits]
    stage.Ground();
    for (int i = 0; i < 10; ++i)
    {
        stage.Ball(0.1f * float32(i % 3), 1.0f + 1.1f * float32(i));
    }
    stage.Run(10.0f);
    std::string places;
    for (const b2Body* body = stage.world.GetBodyList(); body; body = body->GetNext())
    {
        const b2Vec2 p = body->GetPosition();
        places.append(reinterpret_cast<const char*>(&p), sizeof p);
    }
    return places;
}

TEST(IntroductionListing, GivesTheSameBitsWithAnyNumberOfThreads)
{
    EXPECT_EQ(Heap(1), Heap(1));
    EXPECT_EQ(Heap(1), Heap(3));
}

} // namespace
