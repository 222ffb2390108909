// SPDX-License-Identifier: MIT
#include <golden/GoldenWorld.h>

#include <Box2D/Box2D.h>
#include <debugdraw/DrawCollector.h>
#include <golden/StateHash.h>

#include <gmock/gmock.h>

using namespace boxreel;

namespace
{

struct GoldenWorld : testing::Test
{
    GoldenWorld()
    {
        b2BodyDef body;
        b2PolygonShape box;
        box.SetAsBox(0.5f, 0.5f);
        body.type = b2_dynamicBody;
        body.position.Set(100.0f, 50.0f);
        world.CreateBody(&body)->CreateFixture(&box, 1.0f);
        b2EdgeShape ground;
        ground.Set(b2Vec2(-1000.0f, 49.0f), b2Vec2(1000.0f, 49.0f));
        body.type = b2_staticBody;
        body.position.SetZero();
        world.CreateBody(&body)->CreateFixture(&ground, 0.0f);
    }
    b2World world{b2Vec2(0.0f, -10.0f)};
};

/// Counts the pixels of the dynamic body's colour, including the drawing around it.
int ReddishPixels(const Frame& frame)
{
    int count = 0;
    for (std::size_t i = 0; i < frame.rgba.size(); i += 4)
    {
        count += frame.rgba[i] > frame.rgba[i + 1] + 8 ? 1 : 0;
    }
    return count;
}

TEST_F(GoldenWorld, HasStateDrawListAndPixels)
{
    const Result<GoldenCandidate> candidate = CandidateOf(world, "box/0s");
    ASSERT_TRUE(candidate) << candidate.GetError().Text();
    EXPECT_EQ(candidate->name, "box/0s");
    EXPECT_EQ(candidate->stateHash, StateHashText(world));
    EXPECT_EQ(candidate->list, DrawListOf(world));
    EXPECT_NE(candidate->renderer, "") << "it may have a picture of its own";
    EXPECT_EQ(candidate->frame.width, 480);
    EXPECT_EQ(candidate->frame.height, 270);
}

TEST_F(GoldenWorld, FillsThePictureWithMovableBodies)
{
    const Result<GoldenCandidate> candidate = CandidateOf(world, "box");
    ASSERT_TRUE(candidate) << candidate.GetError().Text();
    // A box of a metre that is half of the view's height or more, not a dot on a ground of 2 km.
    EXPECT_GT(ReddishPixels(candidate->frame), 100 * 100);
}

TEST_F(GoldenWorld, IsDrawnWithTheGivenCamera)
{
    const Camera elsewhere{200, 100, 0.0, 0.0, 10.0};
    const Result<GoldenCandidate> candidate = CandidateOf(world, "box", {.camera = elsewhere});
    ASSERT_TRUE(candidate) << candidate.GetError().Text();
    EXPECT_EQ(candidate->frame.width, 200);
    EXPECT_EQ(candidate->frame.height, 100);
    EXPECT_EQ(ReddishPixels(candidate->frame), 0);
}

TEST_F(GoldenWorld, ShowsTheGivenLayers)
{
    const std::uint32_t layers = b2Draw::e_shapeBit | b2Draw::e_aabbBit;
    const Result<GoldenCandidate> candidate = CandidateOf(world, "box", {.layers = layers});
    ASSERT_TRUE(candidate) << candidate.GetError().Text();
    EXPECT_EQ(candidate->list, DrawListOf(world, layers));
    EXPECT_NE(candidate->list, DrawListOf(world));
}

TEST_F(GoldenWorld, IsRefusedForInvalidSize)
{
    const Result<GoldenCandidate> candidate = CandidateOf(world, "box", {.width = 0});
    ASSERT_FALSE(candidate);
    EXPECT_EQ(candidate.GetError().kind, ErrorKind::Unusable);
}

} // namespace
