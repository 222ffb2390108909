// SPDX-License-Identifier: MIT
#include <golden/GoldenTest.h>

#include "../base/TemporaryFolder.h"
#include "Environment.h"
#include "TestPictures.h"

#include <Box2D/Box2D.h>

#include <golden/StateHash.h>
#include <render/Png.h>

#include <gtest/gtest-spi.h>

using namespace boxreel;
using namespace boxreel::test;

namespace
{

/// Checks in a folder of their own. A name serves one candidate a run of the program, hence each
/// test has its own.
struct GoldenMacros : testing::Test
{
    GoldenMacros()
    {
        environment.references.Set((folder / "approved").c_str());
        environment.output.Set((folder / "output").c_str());
    }
    void Accept(const char* what) { environment.accept.Set(what); }

    TemporaryFolder folder;
    GoldenEnvironment environment;
    Frame frame = Painted(SmallScene());
    b2World world{b2Vec2(0.0f, -10.0f)};
};

b2Body* AddBall(b2World& world, float x)
{
    b2BodyDef body;
    body.type = b2_dynamicBody;
    body.position.Set(x, 2.0f);
    b2CircleShape ball;
    ball.m_radius = 0.5f;
    b2Body* const made = world.CreateBody(&body);
    made->CreateFixture(&ball, 1.0f);
    return made;
}

/// For EXPECT_FATAL_FAILURE, whose statement sees nothing of the test.
void AssertFrame()
{
    ASSERT_GOLDEN(Painted(SmallScene()), "asserted/frame");
    FAIL() << "the test went on";
}
void AssertWorld()
{
    b2World world(b2Vec2(0.0f, -10.0f));
    AddBall(world, 0.0f);
    ASSERT_GOLDEN_WORLD(world, "asserted/world");
    FAIL() << "the test went on";
}

TEST_F(GoldenMacros, AcceptPassAndFailAFrame)
{
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN(frame, "macro/frame"),
                            "macro/frame: there is no reference");
    Accept("missing");
    testing::internal::CaptureStdout();
    EXPECT_GOLDEN(frame, "macro/frame");
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
              "accepted  macro/frame: there was no reference.\n");
    Accept(nullptr);
    EXPECT_GOLDEN(frame, "macro/frame");
    FillRect(frame, 10, 10, 20, 20, kLight);
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN(frame, "macro/frame"), "macro/frame: other pixels");
    EXPECT_TRUE(std::filesystem::exists(folder / "output/macro/frame.difference.png"));
}

TEST_F(GoldenMacros, CompareAcrossMachinesForOtherRenderer)
{
    GoldenCandidate approved;
    approved.name = "macro/other";
    approved.frame = frame;
    approved.fingerprint = "0123456789abcdef";
    ASSERT_TRUE(ReferenceStore(folder / "approved", folder / "output").Accept(approved));
    EXPECT_GOLDEN(Painted(SmallScene(), {.fillShift = 1}), "macro/other");
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN(Painted(SmallScene(), {.fillShift = 1}), "macro/other",
                                          CompareSettings::SameMachine()),
                            "macro/other: other pixels");
}

TEST_F(GoldenMacros, ApplyGivenLimitsToAFrame)
{
    Accept("missing");
    EXPECT_GOLDEN(frame, "macro/limits");
    frame.Pixel(5, 5)[0] ^= 0xff;
    EXPECT_GOLDEN(frame, "macro/limits"); // a single stray pixel
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN(frame, "macro/limits", CompareSettings::Exact()),
                            "macro/limits: other pixels");
}

TEST_F(GoldenMacros, RefuseAFrameWithoutPixels)
{
    Accept("all");
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN(Frame(), "macro/empty"),
                            "macro/empty: Frame() has no pixels; draw it before it is compared.");
}

TEST_F(GoldenMacros, ReportChangedMotionOfAcceptedWorld)
{
    b2Body* const ball = AddBall(world, 0.0f);
    Accept("missing");
    EXPECT_GOLDEN_WORLD(world, "macro/world");
    Accept(nullptr);
    EXPECT_GOLDEN_WORLD(world, "macro/world");
    ball->SetLinearVelocity(b2Vec2(0.001f, 0.0f)); // nothing that a picture shows
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN_WORLD(world, "macro/world"),
                            "macro/world: the worlds differ");
}

TEST_F(GoldenMacros, ReportFirstDifferingStepOfTrace)
{
    Accept("missing");
    for (const float push : {0.0f, 1.0f})
    {
        b2World falling(b2Vec2(0.0f, -10.0f));
        AddBall(falling, 0.0f);
        b2Body* const pushed = AddBall(falling, 3.0f);
        StateTrace trace;
        for (int step = 1; step <= 6; ++step)
        {
            pushed->ApplyForceToCenter(b2Vec2(step == 4 ? push : 0.0f, 0.0f), true);
            falling.Step(1.0f / 60.0f, 8, 3);
            trace.steps.push_back(ReadTraceStep(falling, step));
        }
        if (push == 0.0f)
        {
            EXPECT_GOLDEN_WORLD(falling, "macro/way", {.trace = trace});
            Accept(nullptr);
            EXPECT_GOLDEN_WORLD(falling, "macro/way", {.trace = trace});
            continue;
        }
        EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN_WORLD(falling, "macro/way", {.trace = trace}),
                                "macro/way: the worlds differ from step 4 on, body 1 first");
    }
}

TEST_F(GoldenMacros, ApplyGivenLookToAWorld)
{
    AddBall(world, 0.0f);
    Accept("missing");
    EXPECT_GOLDEN_WORLD(world, "macro/look", {.width = 64, .height = 48});
    const Result<Frame> picture = ReadPng(folder / "approved/frames/macro/look.png");
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 64);
    EXPECT_EQ(picture->height, 48);
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN_WORLD(world, "macro/no-look", {.width = -1}), "-1");
}

TEST_F(GoldenMacros, EndTheTestWhenAsserting)
{
    EXPECT_FATAL_FAILURE(AssertFrame(), "asserted/frame: there is no reference");
    EXPECT_FATAL_FAILURE(AssertWorld(), "asserted/world: there is no reference");
}

TEST_F(GoldenMacros, FailWithoutAFolderOfReferences)
{
    environment.references.Set(nullptr);
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN(frame, "macro/nowhere"), "BOXREEL_GOLDEN_REFERENCES: ");
}

TEST_F(GoldenMacros, AttachPicturesUnderCTest)
{
    environment.ctest.Set("3.25.1");
    testing::internal::CaptureStdout();
    EXPECT_NONFATAL_FAILURE(EXPECT_GOLDEN(frame, "macro/attached"), "no reference");
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
              "<CTestMeasurementFile type=\"image/png\" name=\"TestImage\">" +
                  (folder / "output/macro/attached.actual.png").string() +
                  "</CTestMeasurementFile>\n");
}

} // namespace
