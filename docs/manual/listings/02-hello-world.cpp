// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <cstdio>
#include <sstream>
#include <vector>

namespace
{

void FallingBox()
{
    // [world]
    b2World world(b2Vec2(0.0f, -10.0f)); // gravity [m/s^2]
    // [/world]

    // [ground]
    b2BodyDef groundDef; // static unless said otherwise
    groundDef.position.Set(0.0f, -10.0f);
    b2Body* ground = world.CreateBody(&groundDef);

    b2PolygonShape groundBox;
    groundBox.SetAsBox(50.0f, 10.0f);        // 100 m wide, 20 m high
    ground->CreateFixture(&groundBox, 0.0f); // a static body needs no density
    // [/ground]

    // [box]
    b2BodyDef boxDef;
    boxDef.type = b2_dynamicBody; // without this it stays where it is
    boxDef.position.Set(0.0f, 4.0f);
    b2Body* box = world.CreateBody(&boxDef);

    b2PolygonShape square;
    square.SetAsBox(1.0f, 1.0f);
    b2FixtureDef material;
    material.shape = &square;
    material.density = 1.0f; // [kg/m^2]: 4 kg in all
    material.friction = 0.3f;
    box->CreateFixture(&material);
    // [/box]

    // [steps]
    const float32 timeStep = 1.0f / 60.0f; // [s]
    const int32 velocityIterations = 6;
    const int32 positionIterations = 2;
    for (int32 step = 1; step <= 60; ++step)
    {
        world.Step(timeStep, velocityIterations, positionIterations);
        const b2Vec2 p = box->GetPosition();
        std::printf("%2d: x %.2f y %.2f angle %.2f\n", step, p.x, p.y, box->GetAngle());
    }
    // [/steps]
}

/// The lines between the fences of the page's first block of text.
std::vector<std::string> ShownLines()
{
    const std::string page = manual::PageText("02-hello-world.md");
    const std::size_t start = page.find("```text\n") + 8;
    std::istringstream block(page.substr(start, page.find("```", start) - start));
    std::vector<std::string> lines;
    for (std::string line; std::getline(block, line);)
    {
        if (line != "...")
        {
            lines.push_back(line);
        }
    }
    return lines;
}

TEST(HelloWorldListing, PrintsWhatThePageShows)
{
    testing::internal::CaptureStdout();
    FallingBox();
    const std::string printed = "\n" + testing::internal::GetCapturedStdout();
    const std::vector<std::string> shown = ShownLines();
    ASSERT_EQ(shown.size(), 6u);
    for (const std::string& line : shown)
    {
        EXPECT_THAT(printed, testing::HasSubstr("\n" + line + "\n"));
    }
    EXPECT_TRUE(printed.ends_with("\n" + shown.back() + "\n"));
}

TEST(HelloWorldListing, TakesAsLongWithLongerFramesAsWithShortOnes)
{
    manual::Stage stage;
    b2Body* ball = stage.Ball(0.0f, 0.0f);
    b2World& world = stage.world;
    float32 simulated = 0.0f;
    float32 accumulated = 0.0f;
    for (const float32 frameTime : {0.02f, 0.1f, 0.005f, 0.0f, 0.375f, 5.0f})
    {
        // [fixed-steps]
        accumulated += b2Min(frameTime, 0.25f); // a pause of the program is no flight
        while (accumulated >= 1.0f / 60.0f)
        {
            world.Step(1.0f / 60.0f, 8, 3);
            accumulated -= 1.0f / 60.0f;
        }
        // [/fixed-steps]
        simulated += b2Min(frameTime, 0.25f);
    }
    const float32 steps = std::floor(60.0f * simulated + 0.001f);
    EXPECT_EQ(steps, 37.0f);
    // Symplectic Euler falls by g h^2 n (n + 1) / 2.
    EXPECT_NEAR(ball->GetPosition().y, -10.0f / 3600.0f * steps * (steps + 1.0f) / 2.0f, 1e-4f);
}

} // namespace
