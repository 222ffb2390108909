// SPDX-License-Identifier: MIT
#include <workbench/SceneWork.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

struct SceneWorkTest : testing::Test
{
    SceneWork work{*SceneSession::Open(*OpenScene("pyramid"), {})};

    void Begin(int subSteps = 1)
    {
        SolverChoices wanted = SolverOf(work.Session());
        wanted.subSteps = subSteps;
        work.Begin(wanted);
    }
};

TEST_F(SceneWorkTest, SetsAndLogsWhatDiffersFromTheScene)
{
    Begin(4);
    EXPECT_EQ(work.Session().World().GetSubStepCount(), 4);
    EXPECT_EQ(work.Preferred().subSteps, 1);
    EXPECT_THAT(work.Script(), testing::HasSubstr("set sub-steps 4"));
}

TEST_F(SceneWorkTest, KeepsThePointUnderTheMouseWhenZooming)
{
    Begin();
    const Vec2 pixel{100.0f, 600.0f};
    const b2Vec2 before = work.WorldAt(pixel);
    const double scale = work.View().pixelsPerMeter;
    work.Zoom(2.0, pixel);
    EXPECT_NEAR(work.View().pixelsPerMeter, 2.0 * scale, 1e-9 * scale);
    EXPECT_NEAR(work.WorldAt(pixel).x, before.x, 1e-4f);
    EXPECT_NEAR(work.WorldAt(pixel).y, before.y, 1e-4f);
}

TEST_F(SceneWorkTest, ShowsTheSameAfterTheOriginIsShifted)
{
    Begin();
    const b2Body& body = *work.Session().World().GetBodyList();
    const auto seenAt = [&] {
        return work.View().ToPixel({body.GetPosition().x, body.GetPosition().y});
    };
    const Vec2 before = seenAt();
    work.Shift(2.0f, -3.0f);
    EXPECT_NEAR(seenAt().x, before.x, 1e-2f);
    EXPECT_NEAR(seenAt().y, before.y, 1e-2f);
}

TEST_F(SceneWorkTest, StepsOnceWhenItIsPaused)
{
    Begin();
    work.Session().Pause(true);
    work.Step();
    EXPECT_EQ(work.Session().SceneStep(), 1);
}

} // namespace
} // namespace boxreel
