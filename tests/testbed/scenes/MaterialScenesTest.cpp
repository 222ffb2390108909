// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

// Scenes about what happens between bodies: platforms, belts, sensors, materials, filters.
namespace boxreel
{
namespace
{

TEST(OneSidedPlatformScene, LetsWhatRisesThroughAndHoldsWhatFalls)
{
    const auto scene = Make("One-Sided Platform");
    const std::vector<b2Body*> movers = Movers(*scene);
    b2Body* climber = movers.back();
    std::vector<float32> floors;
    Play(*scene, 8.0f, [&] {
        if (climber->GetLinearVelocity().Length() < 0.05f)
        {
            floors.push_back(climber->GetPosition().y);
        }
    });
    for (const float32 floor : {0.5f, 4.5f, 8.5f, 12.5f})
    {
        EXPECT_TRUE(std::ranges::any_of(floors, [=](float32 y) {
            return b2Abs(y - floor) < 0.03f;
        })) << floor;
    }
    EXPECT_TRUE(std::ranges::all_of(movers, [](b2Body* body) {
        return body->GetPosition().y > 4.0f; // the crates have stayed on their platforms
    }));
}

TEST(OneSidedPlatformScene, MovesClimberByKeys)
{
    const auto scene = Make("One-Sided Platform");
    b2Body* climber = Movers(*scene).back();
    scene->KeyDown('a');
    Play(*scene, 1.0f);
    scene->KeyUp('a');
    EXPECT_NEAR(climber->GetPosition().x, -4.0f, 0.5f);
}

TEST(ConveyorBeltScene, CarriesEveryCrateToTheEndOfTheLowerBelt)
{
    const auto scene = Make("Conveyor Belt");
    Play(*scene, 1.5f);
    EXPECT_NEAR(Movers(*scene).front()->GetLinearVelocity().x, 4.0f, 0.2f) << "on the upper belt";
    Play(*scene, 18.5f);
    const std::vector<b2Body*> crates = Movers(*scene);
    ASSERT_EQ(crates.size(), 14u);
    for (const b2Body* crate : crates)
    {
        // The belt ends at -4. A crate of 0.9 m that fell there may tumble back by its width.
        EXPECT_TRUE(crate->GetPosition().x < -3.1f && crate->GetPosition().y < 4.0f)
            << crate->GetPosition().x << ", " << crate->GetPosition().y;
    }
}

TEST(ConveyorBeltScene, StandsStillAndRunsBackOnKeys)
{
    const auto scene = Make("Conveyor Belt");
    Play(*scene, 1.5f);
    scene->KeyDown('t');
    Play(*scene, 1.2f);
    EXPECT_LT(Movers(*scene).front()->GetLinearVelocity().x, -2.0f);
    scene->KeyDown('s');
    Play(*scene, 1.0f);
    EXPECT_EQ(scene->Describe().front().second, "0.00 m/s");
}

TEST(SensorTestScene, PullsOnlyBodiesInTheSensor)
{
    const auto scene = Make("Sensor Test");
    Play(*scene, 12.0f);
    int held = 0;
    for (const b2Body* ball : Movers(*scene))
    {
        const float32 distance = b2Distance(ball->GetPosition(), b2Vec2(0.0f, 9.0f));
        held += distance < 3.0f ? 1 : 0;
        EXPECT_TRUE(distance < 3.0f || ball->GetPosition().y < 4.0f) << distance;
    }
    EXPECT_GE(held, 7);
    EXPECT_LE(held, 17);
    EXPECT_EQ(scene->Describe().front().second, std::to_string(held));
}

TEST(VaryingRestitutionScene, BouncesEachBallToHeightOfRestitution)
{
    const auto scene = Make("Varying Restitution");
    const std::vector<b2Body*> balls = Movers(*scene);
    ASSERT_EQ(balls.size(), 7u);
    std::vector<float32> highest(balls.size(), 0.0f);
    std::vector<bool> hasBounced(balls.size(), false);
    // The fall of 12 m takes 1.55 s, the highest bounce as long again.
    Play(*scene, 3.2f, [&] {
        for (std::size_t i = 0; i < balls.size(); ++i)
        {
            hasBounced[i] = hasBounced[i] || balls[i]->GetPosition().y < 1.3f;
            if (hasBounced[i])
            {
                highest[i] = std::max(highest[i], balls[i]->GetPosition().y);
            }
        }
    });
    for (std::size_t i = 0; i < balls.size(); ++i)
    {
        const float32 e = static_cast<float32>(i) / 6.0f;
        EXPECT_NEAR(highest[i], 1.0f + e * e * 12.0f, 0.45f) << i;
    }
}

TEST(VaryingFrictionScene, SlidesBoxesFartherWithLessFriction)
{
    const auto scene = Make("Varying Friction");
    const std::vector<b2Body*> boxes = Movers(*scene);
    ASSERT_EQ(boxes.size(), 5u);
    const float32 start = boxes[0]->GetPosition().x;
    Play(*scene, 8.0f);
    EXPECT_NEAR(boxes[0]->GetPosition().x, start, 0.05f) << "it should hold on the slope";
    for (std::size_t i = 1; i < boxes.size(); ++i)
    {
        EXPECT_GT(boxes[i]->GetPosition().x, boxes[i - 1]->GetPosition().x + 1.0f) << i;
    }
}

TEST(CollisionFilteringScene, CollidesAsMasksAndGroupsAllow)
{
    const auto scene = Make("Collision Filtering");
    Play(*scene, 8.0f);
    const std::vector<b2Body*> bodies = Movers(*scene);
    ASSERT_EQ(bodies.size(), 18u);
    float32 highestFriend = 0.0f;
    float32 highestStranger = 0.0f;
    float32 lowestDisc = 100.0f;
    for (std::size_t i = 0; i < bodies.size(); i += 3)
    {
        lowestDisc = std::min(lowestDisc, i < 9 ? 100.0f : bodies[i]->GetPosition().y);
        highestFriend = std::max(highestFriend, bodies[i + 1]->GetPosition().y);
        highestStranger = std::max(highestStranger, bodies[i + 2]->GetPosition().y);
    }
    EXPECT_LT(lowestDisc, 0.8f) << "discs pass through the stack of boxes";
    EXPECT_NEAR(highestFriend, 11.0f * 0.7071f * 0.8f, 0.2f) << "six boxes on each other";
    EXPECT_LT(highestStranger, 0.9f) << "all on the ground, in the same place";
}

TEST(CollisionProcessingScene, ReducesNumberOfBallsAndKeepsMass)
{
    const auto scene = Make("Collision Processing");
    const auto mass = [&] {
        float32 sum = 0.0f;
        for (const b2Body* ball : Movers(*scene))
        {
            sum += ball->GetMass();
        }
        return sum;
    };
    ASSERT_EQ(Movers(*scene).size(), 36u);
    const float32 atStart = mass();
    Play(*scene, 3.0f);
    EXPECT_LT(Movers(*scene).size(), 30u);
    scene->ThrowBomb();
    Play(*scene, 7.0f);
    scene->ThrowBomb();
    Play(*scene, 0.1f);
    const std::size_t left = Movers(*scene).size() - 1; // without the bomb
    EXPECT_LT(left, 12u);
    EXPECT_GE(left, 1u);
    EXPECT_NEAR(mass() - Movers(*scene).back()->GetMass(), atStart, 0.001f * atStart);
}

} // namespace
} // namespace boxreel
