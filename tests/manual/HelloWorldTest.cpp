// SPDX-License-Identifier: MIT
#include <Box2D/Box2D.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

/// The manual's first program, unchanged: a ground box, a falling box, one second.
namespace
{

std::vector<std::string> RunHelloWorld()
{
    b2Vec2 gravity(0.0f, -10.0f);
    b2World world(gravity);

    b2BodyDef groundBodyDef;
    groundBodyDef.position.Set(0.0f, -10.0f);
    b2Body* groundBody = world.CreateBody(&groundBodyDef);
    b2PolygonShape groundBox;
    groundBox.SetAsBox(50.0f, 10.0f);
    groundBody->CreateFixture(&groundBox, 0.0f);

    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.position.Set(0.0f, 4.0f);
    b2Body* body = world.CreateBody(&bodyDef);
    b2PolygonShape dynamicBox;
    dynamicBox.SetAsBox(1.0f, 1.0f);
    b2FixtureDef fixtureDef;
    fixtureDef.shape = &dynamicBox;
    fixtureDef.density = 1.0f;
    fixtureDef.friction = 0.3f;
    body->CreateFixture(&fixtureDef);

    float32 timeStep = 1.0f / 60.0f;
    int32 velocityIterations = 6;
    int32 positionIterations = 2;
    std::vector<std::string> lines;
    for (int32 i = 0; i < 60; ++i)
    {
        world.Step(timeStep, velocityIterations, positionIterations);
        b2Vec2 position = body->GetPosition();
        float32 angle = body->GetAngle();
        char line[64];
        std::snprintf(line, sizeof line, "%4.2f %4.2f %4.2f", double(position.x),
                      double(position.y), double(angle));
        lines.push_back(line);
    }
    return lines;
}

TEST(HelloWorld, PrintsTheManualsFirstThreeLines)
{
    const std::vector<std::string> lines = RunHelloWorld();
    EXPECT_EQ(lines[0], "0.00 4.00 0.00");
    EXPECT_EQ(lines[1], "0.00 3.99 0.00");
    EXPECT_EQ(lines[2], "0.00 3.98 0.00");
}

TEST(HelloWorld, PrintsTheManualsLastLinesWhenTheBoxLands)
{
    const std::vector<std::string> lines = RunHelloWorld();
    EXPECT_EQ(lines[43], "0.00 1.25 0.00");
    EXPECT_EQ(lines[44], "0.00 1.13 0.00");
    EXPECT_EQ(lines[45], "0.00 1.01 0.00");
}

TEST(HelloWorld, LeavesTheBoxWhereItLanded)
{
    const std::vector<std::string> lines = RunHelloWorld();
    for (std::size_t i = 45; i < lines.size(); ++i)
    {
        EXPECT_EQ(lines[i], "0.00 1.01 0.00") << "line " << i + 1;
    }
}

} // namespace
