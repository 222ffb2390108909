// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

// Scenes about shapes and what bodies are made of.
namespace boxreel
{
namespace
{

TEST(EdgeTestScene, WhoKnowsItsNeighboursIsSmooth)
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

TEST(EdgeShapesScene, TheHillsCarryWhatFalls)
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

TEST(PolygonShapesScene, TheProbeFindsWhatOverlapsIt)
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

} // namespace
} // namespace boxreel
