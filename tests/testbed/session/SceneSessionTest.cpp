// SPDX-License-Identifier: MIT
// Moments between two steps, as films show them with --interpolate.
#include <session/SceneSession.h>

#include <gtest/gtest.h>

namespace boxreel
{
namespace
{

SceneSession Open(const std::string& scene, const SceneLook& look = {})
{
    return *SceneSession::Open(*OpenScene(scene), look);
}

DrawList Show(SceneSession& session)
{
    FrameContent content;
    session.Fill(content);
    return content.list;
}

DrawList ShowBetween(SceneSession& session, std::int64_t step, double fraction)
{
    session.AdvanceBetween(step, fraction);
    return Show(session);
}

TEST(SceneSession, InterpolatesBetweenSteps)
{
    SceneSession steps = Open("tumbler");
    SceneSession between = Open("tumbler");
    steps.AdvanceTo(40);
    const DrawList before = Show(steps);
    steps.AdvanceTo(41);
    const DrawList after = Show(steps);
    const DrawList quarter = ShowBetween(between, 40, 0.25);
    ASSERT_EQ(quarter.points.size(), before.points.size());
    ASSERT_EQ(quarter.points.size(), after.points.size());
    const float kTurned = 1e-3f; // [m]: an arc, not its chord
    int moved = 0;
    for (std::size_t i = 0; i < quarter.points.size(); ++i)
    {
        EXPECT_NEAR(quarter.points[i].x, 0.75f * before.points[i].x + 0.25f * after.points[i].x,
                    kTurned);
        EXPECT_NEAR(quarter.points[i].y, 0.75f * before.points[i].y + 0.25f * after.points[i].y,
                    kTurned);
        moved += quarter.points[i] != before.points[i] && quarter.points[i] != after.points[i];
    }
    EXPECT_GT(moved, 0);
}

TEST(SceneSession, ShowsExactStepAfterInterpolation)
{
    SceneSession steps = Open("dominos");
    SceneSession between = Open("dominos");
    for (const int step : {10, 11, 12, 40})
    {
        steps.AdvanceTo(step);
        const DrawList expected = Show(steps);
        EXPECT_EQ(ShowBetween(between, step, 0.0), expected) << step;
        EXPECT_EQ(between.CurrentCamera(), steps.CurrentCamera());
        EXPECT_EQ(between.Time(), steps.Time());
        EXPECT_NE(ShowBetween(between, step, 0.5), expected) << step;
        EXPECT_DOUBLE_EQ(between.Time(), (step + 0.5) / 60.0);
        EXPECT_EQ(between.Step(), step + 1);
        EXPECT_NE(ShowBetween(between, step, 0.75), expected) << step;
    }
}

TEST(SceneSession, ContinuesEquallyAfterInterpolation)
{
    SceneSession steps = Open("pyramid");
    SceneSession between = Open("pyramid");
    for (int step = 0; step < 100; ++step)
    {
        ShowBetween(between, step, 0.3);
    }
    steps.AdvanceTo(100);
    EXPECT_EQ(ShowBetween(between, 100, 0.0), Show(steps));
}

} // namespace
} // namespace boxreel
