// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>

// Scenes with stacks, and with falling and thrown bodies.
namespace boxreel
{
namespace
{

constexpr float32 kFiveCentimetres = 0.05f;

/// Returns the maximum displacement of a scene's dynamic bodies after some time [m].
float32 FarthestWay(const std::string& name, float32 seconds)
{
    const std::unique_ptr<Scene> scene = Make(name);
    std::vector<b2Vec2> starts;
    for (const b2Body* body : Movers(*scene))
    {
        starts.push_back(body->GetPosition());
    }
    Play(*scene, seconds);
    const std::vector<b2Body*> movers = Movers(*scene);
    float32 farthest = 0.0f;
    for (std::size_t i = 0; i < movers.size(); ++i)
    {
        farthest = std::max(farthest, b2Distance(movers[i]->GetPosition(), starts[i]));
    }
    return farthest;
}

float32 FastestMover(Scene& scene)
{
    float32 fastest = 0.0f;
    for (const b2Body* body : Movers(scene))
    {
        fastest = std::max(fastest, body->GetLinearVelocity().Length());
    }
    return fastest;
}

bool AllSleep(Scene& scene)
{
    return std::ranges::none_of(Movers(scene), [](const b2Body* body) { return body->IsAwake(); });
}

class StableScene : public testing::TestWithParam<const char*>
{};

// The pieces of some have skins, and get up by 1 or 2 cm each.
TEST_P(StableScene, StandsForTenSeconds)
{
    EXPECT_LT(FarthestWay(GetParam(), 10.0f), 0.2f);
}

INSTANTIATE_TEST_SUITE_P(Scenes, StableScene,
                         testing::Values("Card House", "Circle Stack", "Many Pyramids",
                                         "High Mass Ratio 1", "High Mass Ratio 2",
                                         "High Mass Ratio 3", "Heavy 1"));

TEST(CardHouseScene, MovesLessThanCardThickness)
{
    EXPECT_LT(FarthestWay("Card House", 10.0f), 0.04f);
}

TEST(LargePyramidScene, SleepsAfterTwoSeconds)
{
    const std::unique_ptr<Scene> scene = Make("Large Pyramid");
    EXPECT_EQ(Movers(*scene).size(), 1275u);
    const b2Body* top = Movers(*scene).back();
    const float32 start = top->GetPosition().y;
    Play(*scene, 2.0f);
    EXPECT_TRUE(AllSleep(*scene));
    EXPECT_NEAR(top->GetPosition().y, start, 1.0f);
}

TEST(ManyPyramidsScene, SleepsAndWakesPyramidsSeparately)
{
    const std::unique_ptr<Scene> scene = Make("Many Pyramids");
    EXPECT_EQ(Movers(*scene).size(), 24u * 36u);
    Play(*scene, 3.0f);
    EXPECT_TRUE(AllSleep(*scene));
    Movers(*scene).front()->SetAwake(true);
    Play(*scene, 0.1f);
    const auto awake =
        std::ranges::count_if(Movers(*scene), [](b2Body* b) { return b->IsAwake(); });
    EXPECT_LE(awake, 36);
}

/// How far the keystone goes down while the load lands changes with the bits, by 1 to 5 cm: the
/// load is put higher by centimetres, and the median of three is judged.
TEST(ArchScene, CarriesItsLoad)
{
    std::array<float32, 3> ways{};
    for (std::size_t i = 0; i < ways.size(); ++i)
    {
        const std::unique_ptr<Scene> scene = Make("Arch");
        const std::vector<b2Body*> movers = Movers(*scene);
        const b2Body* keystone = movers[10];
        const b2Body* lastLoad = movers.back();
        for (b2Body* load : std::span(movers).subspan(21))
        {
            load->SetTransform(load->GetPosition() + b2Vec2(0.0f, 0.01f * float32(i)), 0.0f);
        }
        const float32 start = keystone->GetPosition().y;
        Play(*scene, 10.0f);
        ways[i] = std::abs(keystone->GetPosition().y - start);
        EXPECT_GT(lastLoad->GetPosition().y, keystone->GetPosition().y + 4 * 1.5f);
        EXPECT_LT(std::abs(lastLoad->GetPosition().x), 0.2f);
    }
    std::ranges::sort(ways);
    EXPECT_LT(ways[1], kFiveCentimetres);
}

TEST(DoubleDominoScene, FallsInOrderInBothRows)
{
    const std::unique_ptr<Scene> scene = Make("Double Domino");
    const std::vector<b2Body*> dominoes = Movers(*scene);
    std::vector<int> fallen(30, 0);
    int step = 0;
    Play(*scene, 10.0f, [&] {
        ++step;
        for (std::size_t i = 0; i < 30; ++i)
        {
            // Those on the left, first in order, fall to the left.
            const float32 tilt = (i < 15 ? 1.0f : -1.0f) * dominoes[i]->GetAngle();
            fallen[i] = fallen[i] == 0 && tilt > 0.5f ? step : fallen[i];
        }
    });
    for (std::size_t i = 0; i < 30; ++i)
    {
        EXPECT_GT(fallen[i], i % 15 == 0 ? 0 : fallen[i - 1]) << "domino " << i;
    }
}

TEST(HeavyTwoScene, CarriesHeavyBallOnLightOnes)
{
    const std::unique_ptr<Scene> scene = Make("Heavy 2");
    const b2Body* heavy = Movers(*scene).back();
    Play(*scene, 5.0f);
    EXPECT_NEAR(heavy->GetMass() / Movers(*scene).front()->GetMass(), 100.0f, 0.1f);
    EXPECT_GT(heavy->GetPosition().y, 5.4f);
    EXPECT_LT(FastestMover(*scene), 0.1f);
}

TEST(HeavyOneScene, KeepsHeavyBallOnLightOne)
{
    const std::unique_ptr<Scene> scene = Make("Heavy 1");
    Play(*scene, 5.0f);
    const std::vector<b2Body*> balls = Movers(*scene);
    EXPECT_GT(balls[0]->GetPosition().y, 0.49f);
    EXPECT_GT(balls[1]->GetPosition().y - balls[0]->GetPosition().y, 5.49f);
}

TEST(FarPyramidScene, StandsUntilTheBallComes)
{
    const std::unique_ptr<Scene> scene = Make("Far Pyramid");
    const std::vector<b2Body*> movers = Movers(*scene);
    const b2Body* top = movers[movers.size() - 2];
    const b2Vec2 start = top->GetPosition();
    Play(*scene, 4.0f);
    EXPECT_LT(b2Distance(top->GetPosition(), start), 0.2f);
    const float32 before = movers.back()->GetPosition().x;
    EXPECT_GT(before, 10000.0f - 10.0f) << "the ball rolls on, slow as it is";
}

TEST(SmashScene, KeepsMomentumAndBreaksTheWall)
{
    const std::unique_ptr<Scene> scene = Make("Smash");
    const auto momentum = [&] {
        b2Vec2 sum(0.0f, 0.0f);
        for (const b2Body* body : Movers(*scene))
        {
            sum += body->GetMass() * body->GetLinearVelocity();
        }
        return sum;
    };
    const b2Vec2 before = momentum();
    Play(*scene, 0.9f); // before the first reach the arena's wall
    EXPECT_LT((momentum() - before).Length(), 1e-3f * before.Length());
    const auto moved = std::ranges::count_if(Movers(*scene), [](const b2Body* body) {
        return body->GetLinearVelocity().Length() > 0.5f;
    });
    EXPECT_GT(moved, 500);
}

TEST(OverlapRecoveryScene, RecoversWithoutAJump)
{
    const std::unique_ptr<Scene> scene = Make("Overlap Recovery");
    float32 fastest = 0.0f;
    float32 highest = 0.0f;
    const b2Body* top = Movers(*scene).back();
    Play(*scene, 5.0f, [&] {
        fastest = std::max(fastest, FastestMover(*scene));
        highest = std::max(highest, top->GetPosition().y);
    });
    EXPECT_LT(fastest, 1.0f);
    EXPECT_NEAR(top->GetPosition().y, 5.5f, 0.1f) << "six rows of whole boxes";
    EXPECT_LT(highest, 5.7f);
}

TEST(RainScene, FallsThroughPegsAndStaysInBasin)
{
    const std::unique_ptr<Scene> scene = Make("Rain");
    EXPECT_TRUE(Movers(*scene).empty());
    Play(*scene, 1.0f);
    EXPECT_NEAR(double(Movers(*scene).size()), 60.0, 2.0);
    Play(*scene, 11.0f);
    ASSERT_EQ(Movers(*scene).size(), 300u);
    int below = 0;
    for (const b2Body* drop : Movers(*scene))
    {
        EXPECT_LT(std::abs(drop->GetPosition().x), 14.0f);
        EXPECT_GT(drop->GetPosition().y, 0.0f);
        below += drop->GetPosition().y < 7.0f ? 1 : 0;
    }
    EXPECT_GT(below, 250);
}

} // namespace
} // namespace boxreel
