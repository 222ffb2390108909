// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

// Scenes of fast things, of stacks, and of many small parts.
namespace boxreel
{
namespace
{

TEST(SphereStackScene, OnlyTheTrueColumnStands)
{
    const auto scene = Make("SphereStack");
    const std::vector<b2Body*> balls = Movers(*scene);
    ASSERT_EQ(balls.size(), 20u);
    Play(*scene, 10.0f);
    for (std::size_t i = 0; i < 10; ++i)
    {
        EXPECT_NEAR(balls[i]->GetPosition().x, -3.0f, 0.001f) << i;
        EXPECT_NEAR(balls[i]->GetPosition().y, 0.5f + static_cast<float32>(i), 0.15f) << i;
    }
    for (std::size_t i = 10; i < 20; ++i)
    {
        EXPECT_LT(balls[i]->GetPosition().y, 3.0f) << i;
    }
}

TEST(ConfinedScene, NoBallGetsOut)
{
    const auto scene = Make("Confined");
    scene->KeyDown('c');
    float32 farthest = 0.0f;
    Play(*scene, 10.0f, [&] {
        for (const b2Body* ball : Movers(*scene))
        {
            const b2Vec2 place = b2Abs(ball->GetPosition());
            farthest = std::max({farthest, place.x, place.y});
        }
    });
    EXPECT_EQ(Movers(*scene).size(), 80u);
    EXPECT_LT(farthest, 7.6f); // the walls are 8 m from the middle, a ball's radius is 0.5 m
    EXPECT_GT(farthest, 7.4f);
}

} // namespace
} // namespace boxreel
