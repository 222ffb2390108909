// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

// Scenes about shapes and what bodies are made of.
namespace boxreel
{
namespace
{

TEST(EdgeTestScene, IsSmoothOnEdgesWithNeighbours)
{
    const auto scene = Make("Edge Test");
    const std::vector<b2Body*> movers = Movers(*scene);
    ASSERT_EQ(movers.size(), 4u);
    float32 leftmost = 0.0f;
    float32 rightmost = 0.0f;
    // Box and disc of the lower lane.
    Play(*scene, 2.0f);
    Play(*scene, 8.0f, [&] {
        for (const b2Body* body : {movers[2], movers[3]})
        {
            EXPECT_NEAR(body->GetPosition().y, 0.5f, 0.03f);
            EXPECT_NEAR(b2Abs(body->GetLinearVelocity().x), 8.0f, 0.2f);
        }
        EXPECT_NEAR(movers[2]->GetAngle(), 0.0f, 0.01f);
        leftmost = std::min(leftmost, movers[2]->GetPosition().x);
        rightmost = std::max(rightmost, movers[2]->GetPosition().x);
    });
    EXPECT_LT(leftmost, -10.0f);
    EXPECT_GT(rightmost, 10.0f);
}

TEST(EdgeTestScene, SlowsDiscOnlyOnEdgesWithoutNeighbours)
{
    const auto scene = Make("Edge Test");
    float32 alone = 8.0f;
    float32 neighbours = 8.0f;
    Play(*scene, 1.0f, [&] {
        // The discs, of the upper and of the lower lane.
        alone = std::min(alone, Movers(*scene)[1]->GetLinearVelocity().x);
        neighbours = std::min(neighbours, Movers(*scene)[3]->GetLinearVelocity().x);
    });
    EXPECT_LT(alone, 7.9f);
    EXPECT_GT(neighbours, 7.99f);
    const auto rows = scene->Describe();
    EXPECT_EQ(rows[0].first, "lost on edges alone (orange)");
    EXPECT_GT(std::stof(rows[0].second), 0.1f);
    EXPECT_EQ(rows[1].second, "0.00 m/s");
}

TEST(EdgeShapesScene, CarriesFallingBodiesOnHills)
{
    const auto scene = Make("Edge Shapes");
    Play(*scene, 10.0f);
    ASSERT_EQ(Movers(*scene).size(), 30u);
    for (const b2Body* body : Movers(*scene))
    {
        EXPECT_GT(body->GetPosition().y, -1.2f);
        EXPECT_LT(b2Abs(body->GetPosition().x), 12.0f);
    }
    EXPECT_NE(scene->Describe().front().second, "nothing");
    scene->KeyDown('3');
    EXPECT_EQ(Movers(*scene).size(), 31u);
}

TEST(PolygonShapesScene, FindsBodiesThatOverlapProbe)
{
    const auto scene = Make("Polygon Shapes");
    EXPECT_EQ(scene->Describe().front().second, "0");
    Play(*scene, 10.0f);
    int inside = 0;
    int near = 0;
    for (const b2Body* body : Movers(*scene))
    {
        const float32 distance = b2Distance(body->GetPosition(), b2Vec2(0.0f, 2.2f));
        inside += distance < 2.0f ? 1 : 0;
        near += distance < 2.8f ? 1 : 0;
    }
    const int found = std::stoi(scene->Describe().front().second);
    EXPECT_GE(found, inside);
    EXPECT_LE(found, near);
    EXPECT_GE(inside, 3);
}

TEST(CompoundShapesScene, KeepsBallInBowlOnTable)
{
    const auto scene = Make("Compound Shapes");
    const std::vector<b2Body*> bodies = Movers(*scene);
    Play(*scene, 10.0f);
    const b2Body* bowl = bodies[1];
    const b2Body* ball = bodies[2];
    EXPECT_LT(b2Distance(ball->GetPosition(), bowl->GetPosition()), 1.2f);
    EXPECT_GT(ball->GetPosition().y, 2.5f) << "the table stands";
    for (std::size_t i = 3; i < bodies.size(); ++i)
    {
        EXPECT_GT(bodies[i]->GetPosition().y, 0.0f);
        EXPECT_NE(bodies[i]->GetFixtureList()->GetNext(), nullptr) << "of several shapes";
    }
}

TEST(ShapeEditingScene, TipsWithLoadAndRightsItselfWithout)
{
    const auto scene = Make("Shape Editing");
    const b2Body* toy = Movers(*scene).front();
    const float32 mass = toy->GetMass();
    Play(*scene, 0.9f);
    EXPECT_NEAR(toy->GetAngle(), 0.0f, 0.02f);
    float32 maximum = 0.0f;
    Play(*scene, 2.5f, [&] { maximum = std::max(maximum, b2Abs(toy->GetAngle())); });
    EXPECT_GT(toy->GetMass(), mass + 3.0f);
    EXPECT_GT(maximum, 0.5f);
    scene->KeyDown('d');
    Play(*scene, 8.0f);
    EXPECT_EQ(toy->GetMass(), mass);
    EXPECT_NEAR(toy->GetAngle(), 0.0f, 0.1f);
}

TEST(ShapeEditingScene, KeepsMassWhenShapeBecomesSensor)
{
    const auto scene = Make("Shape Editing");
    scene->KeyDown('c');
    const float32 mass = Movers(*scene).front()->GetMass();
    scene->KeyDown('s');
    EXPECT_EQ(scene->Describe().front().second, "a sensor");
    EXPECT_EQ(Movers(*scene).front()->GetMass(), mass);
}

TEST(CharacterCollisionScene, MovesCharactersEvenlyOverSeams)
{
    const auto scene = Make("Character Collision");
    const std::vector<b2Body*> characters = Movers(*scene);
    ASSERT_EQ(characters.size(), 9u);
    Play(*scene, 0.5f);
    std::vector<float32> heights;
    for (const b2Body* body : characters)
    {
        heights.push_back(body->GetPosition().y);
    }
    Play(*scene, 9.5f, [&] {
        for (std::size_t i = 0; i < characters.size(); ++i)
        {
            EXPECT_NEAR(b2Abs(characters[i]->GetLinearVelocity().x), 5.0f, 0.1f) << i;
            EXPECT_NEAR(characters[i]->GetPosition().y, heights[i], 0.02f) << i;
        }
    });
}

} // namespace
} // namespace boxreel
