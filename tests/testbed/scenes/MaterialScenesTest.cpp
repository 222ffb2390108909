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

TEST(OneSidedPlatformScene, TheClimberGoesWhereTheKeysSay)
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
        EXPECT_TRUE(crate->GetPosition().x < -4.0f && crate->GetPosition().y < 4.0f)
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

TEST(SensorTestScene, PullsWhatIsInItAndNothingElse)
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

} // namespace
} // namespace boxreel
