// SPDX-License-Identifier: MIT
#include "EveryScene.h"
#include "ScenePlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <vector>

// The main property of each scene, with the default steps.
namespace boxreel
{
namespace
{

constexpr float32 kOneCentimetre = 0.01f;

/// Every bit that a step can change, of every body.
std::vector<uint32> State(Scene& scene)
{
    std::vector<uint32> state;
    for (b2Body* body = scene.World().GetBodyList(); body != nullptr; body = body->GetNext())
    {
        const float32 values[] = {
            body->GetPosition().x,       body->GetPosition().y,       body->GetAngle(),
            body->GetLinearVelocity().x, body->GetLinearVelocity().y, body->GetAngularVelocity()};
        for (float32 value : values)
        {
            uint32 bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            state.push_back(bits);
        }
    }
    return state;
}

TEST(SceneTable, NamesEverySceneOnceWithASummary)
{
    std::set<std::string> names;
    for (const SceneEntry& entry : AllScenes())
    {
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " is there twice";
        EXPECT_NE(std::string(entry.category), "") << entry.name;
        EXPECT_TRUE(std::string(entry.summary).ends_with('.')) << entry.name;
    }
    for (const char* name :
         {"Pyramid", "Vertical Stack", "Bridge", "Chain", "Dominos", "Tumbler", "Newton's Cradle"})
    {
        EXPECT_TRUE(names.contains(name)) << name;
    }
}

class EachScene : public testing::TestWithParam<SceneCase>
{};

TEST_P(EachScene, StaysInBoundsAndCreatesBodiesOnlyAsDeclared)
{
    const auto scene = GetParam()->create(SceneSettings{});
    b2Body* first = scene->World().GetBodyList(); // a place in it
    const b2Vec2 place = first->GetWorldCenter();
    const int32 atStart = first->GetNumber();
    int32 highest = atStart;
    Play(*scene, 10.0f,
         [&] { highest = std::max(highest, scene->World().GetBodyList()->GetNumber()); });
    EXPECT_EQ(highest > atStart, scene->MakesBodiesLater());
    ASSERT_FALSE(Movers(*scene).empty());
    for (const b2Body* body : Movers(*scene))
    {
        EXPECT_LT(b2Distance(body->GetPosition(), place), 80.0f); // false for NaN as well
    }
}

TEST_P(EachScene, MovesEquallyForEqualSeeds)
{
    const auto first = GetParam()->create(SceneSettings{7});
    const auto second = GetParam()->create(SceneSettings{7});
    Play(*first, 3.0f);
    Play(*second, 3.0f);
    EXPECT_EQ(State(*first), State(*second));
}

INSTANTIATE_TEST_SUITE_P(Scenes, EachScene, testing::ValuesIn(EveryScene()), CaseName);

TEST(ScenesWithRandomNumbers, DifferForAnotherSeed)
{
    for (const char* name : {"Vertical Stack", "Bridge", "Tumbler"})
    {
        const auto first = Make(name, 1);
        const auto second = Make(name, 2);
        Play(*first, 1.0f);
        Play(*second, 1.0f);
        EXPECT_NE(State(*first), State(*second)) << name;
    }
}

TEST(PyramidScene, StandsRowByRowAfterTenSeconds)
{
    const auto scene = Make("Pyramid");
    Play(*scene, 10.0f);
    const std::vector<b2Body*> boxes = Movers(*scene);
    ASSERT_EQ(boxes.size(), 210u);

    // The skins of two boxes, b2_polygonRadius each, keep every row up to 2 cm above the one below.
    std::size_t next = 0;
    for (int32 row = 0; row < 20; ++row)
    {
        for (int32 column = 0; column < 20 - row; ++column, ++next)
        {
            EXPECT_NEAR(boxes[next]->GetPosition().y, 0.5f + static_cast<float32>(row),
                        2.0f * kOneCentimetre * static_cast<float32>(row + 1));
            EXPECT_NEAR(boxes[next]->GetAngle(), 0.0f, 0.02f);
        }
    }
}

TEST(VerticalStackScene, StandsUntilTheBallComes)
{
    const auto scene = Make("Vertical Stack");
    std::vector<b2Body*> bodies = Movers(*scene);
    const auto isBox = [](b2Body* body) {
        return body->GetFixtureList()->GetType() == b2Shape::e_polygon;
    };
    std::erase_if(bodies, [&](b2Body* body) { return !isBox(body); });
    ASSERT_EQ(bodies.size(), 50u);
    std::vector<b2Vec2> start;
    for (const b2Body* box : bodies)
    {
        start.push_back(box->GetPosition());
    }

    Play(*scene, 4.9f);
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        EXPECT_NEAR(bodies[i]->GetPosition().x, start[i].x, 10.0f * kOneCentimetre) << "box " << i;
        EXPECT_NEAR(bodies[i]->GetPosition().y, start[i].y, 15.0f * kOneCentimetre) << "box " << i;
    }

    Play(*scene, 5.1f);
    const auto fallen =
        std::ranges::count_if(bodies, [&](b2Body* box) { return box->GetPosition().y < 6.0f; });
    EXPECT_GE(fallen, 45) << "the ball should bring the columns down";
}

TEST(BridgeScene, HoldsWhatFallsOnIt)
{
    const auto scene = Make("Bridge");
    float32 widest = 0.0f;
    Play(*scene, 10.0f, [&] { widest = std::max(widest, WidestJointGap(*scene)); });
    EXPECT_LT(widest, 7.0f * kOneCentimetre) << "while loads fall on it";
    EXPECT_LT(WidestJointGap(*scene), 2.5f * kOneCentimetre) << "when it carries them";

    const std::vector<b2Body*> bodies = Movers(*scene);
    ASSERT_EQ(bodies.size(), 24u + 12u);
    for (std::size_t i = 24; i < bodies.size(); ++i)
    {
        EXPECT_GT(bodies[i]->GetPosition().y, 2.0f) << "load " << i - 24 << " fell through";
        EXPECT_LT(bodies[i]->GetPosition().y, 10.0f);
    }
    EXPECT_LT(bodies[12]->GetPosition().y, 7.5f) << "a loaded bridge sags in the middle";
}

TEST(ChainScene, SwingsToTheOtherSideAndStaysWhole)
{
    const auto scene = Make("Chain");
    const b2Body* tip = Movers(*scene).back();
    const b2Vec2 anchor(0.0f, 20.0f);
    float32 widestGap = 0.0f;
    float32 leftmost = 0.0f;
    float32 farthest = 0.0f;
    Play(*scene, 10.0f, [&] {
        widestGap = std::max(widestGap, WidestJointGap(*scene));
        leftmost = std::min(leftmost, tip->GetPosition().x);
        farthest = std::max(farthest, b2Distance(anchor, tip->GetPosition()));
    });
    EXPECT_LT(widestGap, 6.0f * kOneCentimetre);
    EXPECT_LT(leftmost, -10.0f);
    // Sixteen links of 1.1 m, to the middle of the last: 17.05 m.
    EXPECT_LT(farthest, 17.05f + 0.3f);
}

// The time at which each domino first leans more than 30 degrees [s]; never: 1000.
std::vector<float32> FallingTimes(Scene& scene, const std::vector<b2Body*>& dominoes,
                                  float32 seconds)
{
    std::vector<float32> times(dominoes.size(), 1000.0f);
    float32 now = 0.0f;
    Play(scene, seconds, [&] {
        now += 1.0f / 60.0f;
        for (std::size_t i = 0; i < dominoes.size(); ++i)
        {
            if (std::abs(dominoes[i]->GetAngle()) > b2_pi / 6.0f)
            {
                times[i] = std::min(times[i], now);
            }
        }
    });
    return times;
}

TEST(DominosScene, FallsInOrderAndPutsBallIntoBucket)
{
    const auto scene = Make("Dominos");
    std::vector<b2Body*> dominoes;
    std::vector<b2Body*> balls;
    for (b2Body* body : Movers(*scene))
    {
        const bool isHammer = body->GetJointList() != nullptr;
        const bool isBall = body->GetFixtureList()->GetType() == b2Shape::e_circle;
        if (!isHammer)
        {
            (isBall ? balls : dominoes).push_back(body);
        }
    }
    ASSERT_EQ(dominoes.size(), 22u);
    ASSERT_EQ(balls.size(), 2u);

    const std::vector<float32> times = FallingTimes(*scene, dominoes, 10.0f);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        EXPECT_LT(times[i], 10.0f) << "domino " << i << " still stands";
        if (i > 0)
        {
            EXPECT_LT(times[i - 1], times[i]) << "domino " << i << " fell before its neighbour";
        }
    }
    const b2Vec2 ball = balls[1]->GetPosition();
    EXPECT_TRUE(-12.0f < ball.x && ball.x < -8.0f && ball.y < 2.0f)
        << "the last ball is at " << ball.x << ", " << ball.y << ", not in the bucket";
}

TEST(TumblerScene, KeepsAllItsBoxesInside)
{
    const auto scene = Make("Tumbler");
    Play(*scene, 15.0f);
    const std::vector<b2Body*> boxes = Movers(*scene);
    ASSERT_EQ(boxes.size(), 396u);
    const b2Body* drum = scene->World().GetBodyList();
    while (drum->GetNext() != nullptr)
    {
        drum = drum->GetNext();
    }
    EXPECT_NEAR(drum->GetAngle(), 15.0f * 25.0f * b2_pi / 180.0f, 0.01f);
    for (const b2Body* box : boxes)
    {
        const b2Vec2 local = drum->GetLocalPoint(box->GetPosition());
        // The inner faces are 9.5 m from the centre, a box is at least 0.25 m thick.
        EXPECT_LT(std::max(std::abs(local.x), std::abs(local.y)), 9.25f + 5.0f * kOneCentimetre);
    }
}

TEST(TumblerScene, PoursAtTheSamePaceForAnyTimeStep)
{
    const auto coarse = Make("Tumbler");
    const auto fine = Make("Tumbler");
    for (int32 i = 0; i < 100; ++i)
    {
        coarse->Step(StepSettings{.timeStep = 1.0f / 50.0f});
        fine->Step(StepSettings{.timeStep = 1.0f / 100.0f});
        fine->Step(StepSettings{.timeStep = 1.0f / 100.0f});
    }
    EXPECT_EQ(Movers(*coarse).size(), Movers(*fine).size());
}

TEST(NewtonsCradleScene, PassesTheMomentumToTheLastBall)
{
    const auto scene = Make("Newton's Cradle");
    const std::vector<b2Body*> balls = Movers(*scene);
    ASSERT_EQ(balls.size(), 6u);
    const float32 restHeight = balls[1]->GetPosition().y;
    const float32 startHeight = balls[0]->GetPosition().y - restHeight;
    const float32 startSpeed = std::sqrt(2.0f * 10.0f * startHeight);

    // The first ball reaches the row after about 1.5 s; the swing out is over by 3.2 s.
    float32 fastestFirst = 0.0f;
    float32 highestLast = 0.0f;
    float32 highestBetween = 0.0f;
    Play(*scene, 3.2f, [&] {
        fastestFirst = std::max(fastestFirst, balls[0]->GetLinearVelocity().x);
        highestLast = std::max(highestLast, balls[5]->GetPosition().y - restHeight);
        for (std::size_t i = 1; i < 5; ++i)
        {
            highestBetween = std::max(highestBetween, balls[i]->GetPosition().y - restHeight);
        }
    });
    EXPECT_NEAR(fastestFirst, startSpeed, 0.05f * startSpeed);
    EXPECT_GT(highestLast, 0.9f * startHeight);
    EXPECT_LT(highestBetween, 0.02f * startHeight);
    EXPECT_LT(WidestJointGap(*scene), 8.0f + kOneCentimetre) << "strings do not stretch";
}

} // namespace
} // namespace boxreel
