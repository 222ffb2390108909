// SPDX-License-Identifier: MIT
// Bodies that a golden test leaves out, in worlds that differ in one body.
#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"

#include <golden/GoldenWorld.h>
#include <golden/StateHash.h>

#include <Box2D/Box2D.h>

#include <gmock/gmock.h>

using namespace boxreel;
using testing::HasSubstr;

namespace
{

/// Ground 0, a box 1 and a disc 2.
struct TwoBodies
{
    explicit TwoBodies(float32 discX = 2.0f, float32 boxX = -2.0f)
    {
        b2BodyDef body;
        b2EdgeShape ground;
        ground.Set(b2Vec2(-8.0f, 0.0f), b2Vec2(8.0f, 0.0f));
        world.CreateBody(&body)->CreateFixture(&ground, 0.0f);
        body.type = b2_dynamicBody;
        body.position.Set(boxX, 3.0f);
        b2PolygonShape box;
        box.SetAsBox(0.5f, 0.5f);
        world.CreateBody(&body)->CreateFixture(&box, 1.0f);
        body.position.Set(discX, 3.0f);
        b2CircleShape disc;
        disc.m_radius = 0.7f;
        world.CreateBody(&body)->CreateFixture(&disc, 1.0f);
    }

    b2World world{b2Vec2(0.0f, -10.0f)};
};

struct IgnoredBodies : testing::Test
{
    /// 60 steps, and their trace.
    static GoldenCandidate Seen(TwoBodies scene)
    {
        StateTrace trace;
        for (int step = 1; step <= 60; ++step)
        {
            scene.world.Step(1.0f / 60.0f, 8, 3);
            trace.steps.push_back(ReadTraceStep(scene.world, step));
        }
        const Camera camera{480, 270, 0.0, 2.0, 30.0};
        Result<GoldenCandidate> candidate = CandidateOf(scene.world, "two/1s", {.camera = camera});
        EXPECT_TRUE(candidate);
        candidate->trace = std::move(trace);
        return *std::move(candidate);
    }

    GoldenVerdict Verify(const GoldenCandidate& candidate, std::vector<int> ignored) const
    {
        CompareSettings settings;
        settings.ignoredBodies = std::move(ignored);
        Result<GoldenVerdict> verdict = store.Verify(candidate, settings);
        EXPECT_TRUE(verdict) << verdict.GetError().Text();
        return verdict ? *std::move(verdict) : GoldenVerdict{};
    }

    Error Refusal(const GoldenCandidate& candidate, std::vector<int> ignored) const
    {
        CompareSettings settings;
        settings.ignoredBodies = std::move(ignored);
        const Result<GoldenVerdict> verdict = store.Verify(candidate, settings);
        EXPECT_EQ(verdict->status, GoldenStatus::NotCompared);
        EXPECT_EQ(verdict->accept, "") << "it would not help";
        return verdict->problem;
    }

    TemporaryFolder folder;
    ReferenceStore store{folder / "references", folder / "output"};
};

TEST_F(IgnoredBodies, AreNotComparedAtAnyDepth)
{
    ASSERT_TRUE(store.Accept(Seen(TwoBodies())));
    const GoldenCandidate moved = Seen(TwoBodies(3.5f));
    EXPECT_EQ(Verify(moved, {}).status, GoldenStatus::State);
    EXPECT_EQ(Verify(moved, {1}).status, GoldenStatus::State);
    const GoldenVerdict verdict = Verify(moved, {2});
    EXPECT_EQ(verdict.status, GoldenStatus::Same) << verdict.Text();
    EXPECT_GT(verdict.pixels.ignored, 2 * 42 * 42) << "where it was and where it is";
    EXPECT_LT(verdict.pixels.ignored, 2 * 52 * 52);
    EXPECT_EQ(Verify(moved, {1, 2}).status, GoldenStatus::Same);
}

TEST_F(IgnoredBodies, HideNoDifferenceOfOtherBodies)
{
    ASSERT_TRUE(store.Accept(Seen(TwoBodies())));
    const GoldenVerdict verdict = Verify(Seen(TwoBodies(3.5f, -2.01f)), {2});
    EXPECT_EQ(verdict.status, GoldenStatus::State);
    ASSERT_TRUE(verdict.world && verdict.world->inTrace && verdict.world->now && verdict.list);
    EXPECT_EQ(verdict.world->inTrace->step, 1);
    EXPECT_THAT(verdict.world->inTrace->bodies, testing::ElementsAre(1));
    EXPECT_EQ(verdict.world->now->different, 1u);
    EXPECT_EQ(verdict.world->now->compared, 2u);
    EXPECT_EQ(verdict.world->now->actual.number, 1);
    EXPECT_EQ(verdict.list->line, 2u);
    EXPECT_FALSE(verdict.pixels.equal);

    GoldenCandidate speck = Seen(TwoBodies(3.5f));
    for (int y = 0; y < 3; ++y)
    {
        std::fill_n(speck.frame.Pixel(100, 100 + y), 12, std::uint8_t(255));
    }
    EXPECT_EQ(Verify(speck, {2}).status, GoldenStatus::Pixels);
}

TEST_F(IgnoredBodies, AreRefusedWhenMissing)
{
    GoldenCandidate candidate = Seen(TwoBodies());
    ASSERT_TRUE(store.Accept(candidate));
    const Error absent = Refusal(candidate, {1, 3});
    EXPECT_THAT(absent, IsError(ErrorKind::Unusable, "bodies 1, 3"));
    EXPECT_THAT(absent.problem, AllOf(HasSubstr("3"), HasSubstr("2")));
    candidate.camera.reset();
    EXPECT_THAT(Refusal(candidate, {1}), IsError(ErrorKind::Unusable, "body 1"));
}

TEST_F(IgnoredBodies, AreRefusedWhenTheyAreAllBodies)
{
    const GoldenCandidate candidate = Seen(TwoBodies());
    ASSERT_TRUE(store.Accept(candidate));
    EXPECT_EQ(Verify(candidate, {1, 2}).status, GoldenStatus::Same);
    EXPECT_THAT(Refusal(candidate, {0, 1, 2}), IsError(ErrorKind::Unusable, "bodies 0, 1, 2"));
}

TEST_F(IgnoredBodies, AreRefusedWhenReferenceHasOnlyAHash)
{
    GoldenCandidate candidate = Seen(TwoBodies());
    candidate.state = {};
    candidate.trace = {};
    ASSERT_TRUE(store.Accept(candidate));
    EXPECT_THAT(Refusal(candidate, {2}), IsError(ErrorKind::Unusable, "body 2"));
    GoldenCandidate moved = Seen(TwoBodies(3.5f));
    moved.trace = {};
    EXPECT_EQ(Verify(moved, {2}).status, GoldenStatus::State) << "who knows what was approved";
}

} // namespace
