// SPDX-License-Identifier: MIT
#include <box2d/box2d.h>

#include <gtest/gtest.h>

// A program of the 2.4 generation, as far as names are concerned. Box2D 2.4 may be installed as
// well: whoever links this engine includes this engine.

TEST(Header24, DeclaresThisEngine)
{
    EXPECT_EQ(b2_version.major, 2);
    EXPECT_EQ(b2_version.minor, 3) << "that of Box2D 2.4 says 4";
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    b2Body* body = world.CreateBody(&def);
    world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_LT(body->GetPosition().y, 0.0f);
}
