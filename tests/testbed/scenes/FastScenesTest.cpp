// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

// Scenes of fast things, of stacks, and of many small parts.
namespace boxreel
{
namespace
{

TEST(SphereStackScene, KeepsOnlyExactColumnStanding)
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

TEST(ConfinedScene, KeepsAllBallsInside)
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

TEST(TilesScene, CarriesThePyramid)
{
    const auto scene = Make("Tiles");
    const std::vector<b2Body*> boxes = Movers(*scene);
    ASSERT_EQ(boxes.size(), 78u);
    Play(*scene, 8.0f);
    for (std::size_t i = 0; i < 12; ++i)
    {
        EXPECT_NEAR(boxes[i]->GetPosition().y, 0.5f, 0.05f) << i;
    }
    EXPECT_NEAR(boxes.back()->GetPosition().y, 11.5f, 0.5f);
}

TEST(BulletTestScene, HitsOnlyWithTheBullet)
{
    const auto scene = Make("Bullet Test");
    const std::vector<b2Body*> movers = Movers(*scene);
    ASSERT_EQ(movers.size(), 8u);
    float32 hit = 0.0f;
    float32 missed = 0.0f;
    Play(*scene, 8.0f, [&] {
        for (std::size_t i = 0; i < 3; ++i)
        {
            hit = std::max(hit, b2Abs(movers[i]->GetAngle()));
            missed = std::max(missed, b2Abs(movers[i + 3]->GetAngle()));
        }
    });
    EXPECT_GT(hit, 0.5f);
    EXPECT_LT(missed, 0.01f);
    EXPECT_LT(movers.back()->GetPosition().x, 14.3f) << "the wall stops it nevertheless";
}

TEST(ContinuousTestScene, KeepsBarAboveFloorOnlyWhenContinuous)
{
    const auto scene = Make("Continuous Test");
    b2Body* bar = Movers(*scene).front();
    float32 lowest = 100.0f;
    const auto look = [&] {
        for (const float32 end : {-2.0f, 2.0f})
        {
            lowest = std::min(lowest, bar->GetWorldPoint(b2Vec2(end, 0.0f)).y);
        }
    };
    Play(*scene, 12.0f, look);
    EXPECT_GT(lowest, -0.1f);
    EXPECT_LT(lowest, 0.2f);
    scene->KeyDown('c');
    Play(*scene, 12.0f, look);
    EXPECT_LT(lowest, -2.0f) << "without continuous collision it gets through";
}

TEST(AddPairStressTestScene, MovesBlockThroughField)
{
    const auto scene = Make("Add Pair Stress Test");
    const std::vector<b2Body*> movers = Movers(*scene);
    ASSERT_EQ(movers.size(), 401u);
    int32 maximum = 0;
    Play(*scene, 3.0f, [&] { maximum = std::max(maximum, scene->World().GetContactCount()); });
    EXPECT_GT(maximum, 400);
    EXPECT_GT(movers.back()->GetPosition().x, 8.0f);
    EXPECT_LT(movers.back()->GetLinearVelocity().x, 30.0f);
    for (const b2Body* body : movers)
    {
        const b2Vec2 place = b2Abs(body->GetPosition());
        EXPECT_TRUE(place.x < 16.0f && place.y < 9.0f);
    }
}

} // namespace
} // namespace boxreel
