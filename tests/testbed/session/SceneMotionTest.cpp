// SPDX-License-Identifier: MIT
#include <debugdraw/TextWidth.h>
#include <session/SceneLabels.h>
#include <session/SceneMotion.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

SceneSession Open(const std::string& name)
{
    Result<SceneSource> source = OpenScene(name);
    EXPECT_TRUE(source);
    Result<SceneSession> session = SceneSession::Open(std::move(*source), SceneLook());
    EXPECT_TRUE(session);
    return std::move(*session);
}

DrawList SceneAt(SceneSession& session, std::int64_t step)
{
    session.AdvanceTo(step);
    FrameContent content;
    session.Fill(content);
    return content.list;
}

/// Returns the items that `look` adds to the scene at `step`, without the scene itself.
DrawList Added(const std::string& name, const MotionLook& look, std::int64_t step)
{
    SceneSession session = Open(name);
    Result<SceneMotion> motion = SceneMotion::Create(look, session, {step});
    EXPECT_TRUE(motion) << motion.GetError().Text();
    motion->AdvanceTo(session, step);
    return motion->Picture(session, motion->Notes(session));
}

std::string Refusal(const MotionLook& look, const std::vector<std::int64_t>& moments = {60})
{
    SceneSession session = Open("newtons-cradle");
    const Result<SceneMotion> motion = SceneMotion::Create(look, session, moments);
    return motion ? "accepted" : motion.GetError().culprit;
}

/// The corners and centres of an owner's items.
std::vector<Vec2> PointsOf(const DrawList& list, std::uint32_t owner)
{
    std::vector<Vec2> points;
    for (const DrawItem& item : list.items)
    {
        if (item.owner == owner)
        {
            const auto first = list.points.begin() + std::ptrdiff_t(item.first);
            points.insert(points.end(), first, first + item.count);
        }
    }
    return points;
}

TEST(SceneMotion, AddsNothingByDefault)
{
    SceneSession session = Open("bridge");
    Result<SceneMotion> motion = SceneMotion::Create({}, session, {20});
    ASSERT_TRUE(motion);
    motion->AdvanceTo(session, 20);
    SceneSession plain = Open("bridge");
    const DrawList scene = SceneAt(plain, 20);
    EXPECT_EQ(session.Step(), 20);
    EXPECT_EQ(motion->Picture(session, scene), scene);
}

TEST(SceneMotion, DrawsTrailThroughPlacesOfBody)
{
    MotionLook look;
    look.trail = BodyChoice{false, {1}};
    const DrawList trail = Added("newtons-cradle", look, 50);
    SceneSession session = Open("newtons-cradle");
    std::vector<Vec2> places;
    for (int step = 0; step <= 50; ++step)
    {
        session.AdvanceTo(step);
        const b2Vec2 p = FindBodies(session.World(), {1}).front()->GetWorldCenter();
        places.push_back({p.x, p.y});
    }
    ASSERT_FALSE(trail.points.empty());
    const double pixel = 1.0 / session.CurrentCamera().pixelsPerMeter;
    for (const Vec2 p : trail.points)
    {
        double nearest = 1e9;
        for (std::size_t i = 1; i < places.size(); ++i)
        {
            // Along the line from one place to the next, at 100 points.
            for (float share = 0.0f; share <= 1.0f; share += 0.01f)
            {
                nearest = std::min<double>(
                    nearest, std::hypot(p.x - std::lerp(places[i - 1].x, places[i].x, share),
                                        p.y - std::lerp(places[i - 1].y, places[i].y, share)));
            }
        }
        EXPECT_LT(nearest, 0.3 * pixel);
    }
    EXPECT_NEAR(trail.points.back().x, places.back().x, pixel);
    EXPECT_NEAR(trail.points.front().x, places.front().x, pixel);
    for (const DrawItem& item : trail.items)
    {
        EXPECT_EQ(item.owner, 1u);
        EXPECT_EQ(item.layer, DrawLayer::Trails);
    }
}

TEST(SceneMotion, BeginsTrailAtGivenTimeAgo)
{
    MotionLook look;
    look.trail = BodyChoice{false, {1}};
    look.trailTime = Duration{200'000'000}; // 12 steps
    const DrawList trail = Added("newtons-cradle", look, 50);
    SceneSession session = Open("newtons-cradle");
    session.AdvanceTo(38);
    const b2Vec2 start = FindBodies(session.World(), {1}).front()->GetWorldCenter();
    ASSERT_FALSE(trail.points.empty());
    EXPECT_NEAR(trail.points.front().x, start.x, 1.0 / session.CurrentCamera().pixelsPerMeter);
}

TEST(SceneMotion, DrawsPoseOfEachStrobeMoment)
{
    MotionLook look;
    look.strobe = StrobeChoice{{{}, 10}, {false, {1}}};
    const DrawList poses = Added("newtons-cradle", look, 45);
    SceneSession session = Open("newtons-cradle");
    std::vector<Vec2> expected;
    for (const std::int64_t step : {10, 20, 30, 40})
    {
        const std::vector<Vec2> pose = PointsOf(SceneAt(session, step), 1);
        expected.insert(expected.end(), pose.begin(), pose.end());
    }
    std::vector<Vec2> drawn = PointsOf(poses, 1);
    ASSERT_GE(drawn.size(), expected.size());
    drawn.erase(drawn.begin(), drawn.end() - std::ptrdiff_t(expected.size())); // that of the start
    EXPECT_EQ(drawn, expected);
    EXPECT_EQ(poses.points.size(), expected.size() + expected.size() / 4);
    for (const DrawItem& item : poses.items)
    {
        EXPECT_EQ(item.layer, DrawLayer::Poses);
        EXPECT_LT(item.color.a, 128);
    }
}

TEST(SceneMotion, FadesOlderOnionPoses)
{
    MotionLook look;
    look.onion = OnionChoice{3, {{}, 5}, {false, {1}}};
    const DrawList poses = Added("newtons-cradle", look, 45);
    SceneSession session = Open("newtons-cradle");
    std::vector<Vec2> expected;
    for (const std::int64_t step : {30, 35, 40})
    {
        const std::vector<Vec2> pose = PointsOf(SceneAt(session, step), 1);
        expected.insert(expected.end(), pose.begin(), pose.end());
    }
    EXPECT_EQ(PointsOf(poses, 1), expected);
    EXPECT_LT(poses.items.front().color.a, poses.items.back().color.a);
    EXPECT_TRUE(Added("newtons-cradle", look, 0).items.empty()) << "nothing was before";
}

TEST(SceneMotion, DrawsNoPosesOfBodiesAtRest)
{
    MotionLook look;
    look.strobe = StrobeChoice{{{}, 10}, {}};
    const DrawList poses = Added("newtons-cradle", look, 45);
    EXPECT_FALSE(PointsOf(poses, 1).empty());
    EXPECT_TRUE(PointsOf(poses, 0).empty()) << "the beam is static";
    EXPECT_TRUE(PointsOf(poses, 4).empty()) << "a ball that has not been hit yet";
}

TEST(SceneMotion, MeasuresBetweenBodiesWhereTheyAre)
{
    MotionLook look;
    look.dimensions = {{1, 2}, {3, Vec2{0, 0}}};
    const DrawList list = Added("newtons-cradle", look, 20);
    SceneSession session = Open("newtons-cradle");
    session.AdvanceTo(20);
    const std::vector<const b2Body*> bodies = FindBodies(session.World(), {1, 2});
    const float distance = (bodies[0]->GetWorldCenter() - bodies[1]->GetWorldCenter()).Length();
    ASSERT_EQ(list.texts.size(), 2u);
    EXPECT_NEAR(std::stod(list.texts[0]), distance, 0.005);
}

Vec2 TextAt(const DrawList& list)
{
    const auto text = std::find_if(list.items.begin(), list.items.end(), [](const DrawItem& item) {
        return item.kind == DrawKind::Text;
    });
    return list.points.at(text->first);
}

TEST(SceneMotion, PlacesDimensionTextClearOfLaterDimensions)
{
    SceneSession session = Open("newtons-cradle");
    const float x = float(30.0 / session.CurrentCamera().pixelsPerMeter); // of its line: 0
    MotionLook look;
    look.dimensions = {{Vec2{-6, 8}, Vec2{6, 8}}, {Vec2{x, 4}, Vec2{x, 12}}};
    Result<SceneMotion> motion = SceneMotion::Create(look, session, {0});
    ASSERT_TRUE(motion);
    const DrawList both = motion->Notes(session);
    look.dimensions.pop_back();
    const DrawList first = SceneMotion::Create(look, session, {0})->Notes(session);
    EXPECT_FALSE(TextAt(both) == TextAt(first));
    EXPECT_EQ(both.texts.size(), 2u);
}

TEST(SceneMotion, PlacesDimensionTextClearOfTrailAndPoses)
{
    SceneSession session = Open("newtons-cradle");
    const b2Vec2 start = FindBodies(session.World(), {1}).front()->GetWorldCenter();
    const float pixel = 1.0f / float(session.CurrentCamera().pixelsPerMeter);
    // The text of a horizontal line is 42 pixels above the measured points, half a text included.
    const auto measured = [&](float y) {
        const float below = y - 42.0f * pixel;
        return std::vector<DimensionChoice>{{Vec2{start.x - 4, below}, Vec2{start.x + 4, below}}};
    };
    MotionLook look;
    look.dimensions = measured(start.y);
    const Vec2 overTrail = TextAt(Added("newtons-cradle", look, 45));
    EXPECT_NEAR(overTrail.y, start.y, 8.0f * pixel);
    look.trail = BodyChoice{false, {1}};
    EXPECT_FALSE(TextAt(Added("newtons-cradle", look, 45)) == overTrail);
    look.trail.reset();
    look.dimensions = measured(start.y + 1.0f); // the ball's outline
    const Vec2 overPose = TextAt(Added("newtons-cradle", look, 45));
    EXPECT_NEAR(overPose.y, start.y + 1.0f, 8.0f * pixel);
    look.strobe = StrobeChoice{{{}, 45}, {false, {1}}}; // the start, and now
    EXPECT_FALSE(TextAt(Added("newtons-cradle", look, 45)) == overPose);
}

TEST(SceneMotion, PlacesLabelsClearOfNotes)
{
    Result<SceneSource> source = OpenScene("bridge");
    ASSERT_TRUE(source);
    SceneLook sceneLook;
    sceneLook.labels = true;
    sceneLook.width = 640;
    sceneLook.height = 360;
    Result<SceneSession> session = SceneSession::Open(std::move(*source), sceneLook);
    ASSERT_TRUE(session);
    MotionLook look;
    look.axes = true;
    look.dimensions = {{0, 1}, {34, 28}};
    Result<SceneMotion> motion = SceneMotion::Create(look, *session, {120});
    ASSERT_TRUE(motion);
    motion->AdvanceTo(*session, 120);
    FrameContent content;
    session->Fill(content, motion->Notes(*session));
    const DrawList list = motion->Picture(*session, content.list);
    const auto scale = float(session->CurrentCamera().pixelsPerMeter);
    std::vector<Rect> labels;
    std::vector<Rect> notes;
    for (const DrawItem& item : list.items)
    {
        if (item.kind == DrawKind::Text)
        {
            const Vec2 corner = list.points[item.first];
            const float width = float(TextWidth(list.texts[item.text])) / scale;
            (item.layer == DrawLayer::Labels ? labels : notes)
                .push_back({{corner.x, corner.y - 12.0f / scale}, {corner.x + width, corner.y}});
        }
    }
    notes.push_back({{-8.0f / scale, -1.0f / scale}, {8.0f / scale, 1.0f / scale}}); // the origin
    ASSERT_EQ(notes.size(), 3u);
    EXPECT_GT(labels.size(), 30u);
    for (const Rect& label : labels)
    {
        for (const Rect& note : notes)
        {
            EXPECT_FALSE(label.lower.x < note.upper.x && note.lower.x < label.upper.x &&
                         label.lower.y < note.upper.y && note.lower.y < label.upper.y)
                << label.lower.x << ", " << label.lower.y;
        }
    }
}

TEST(SceneMotion, RefusesMissingBodies)
{
    MotionLook trail;
    trail.trail = BodyChoice{false, {1, 99}};
    EXPECT_EQ(Refusal(trail), "--trail 99");
    MotionLook strobe;
    strobe.strobe = StrobeChoice{{{}, 10}, {false, {8}}};
    EXPECT_EQ(Refusal(strobe), "--strobe 8");
    MotionLook onion;
    onion.onion = OnionChoice{3, {{}, 5}, {false, {9}}};
    EXPECT_EQ(Refusal(onion), "--onion 9");
    MotionLook dimension;
    dimension.dimensions = {{1, 2}, {Vec2{0, 0}, 7}};
    EXPECT_EQ(Refusal(dimension), "--dimension 7");
}

TEST(SceneMotion, RefusesTooManyPoses)
{
    MotionLook look;
    look.strobe = StrobeChoice{{{}, 1}, {}};
    EXPECT_EQ(Refusal(look, {2000}), "accepted");
    EXPECT_EQ(Refusal(look, {2001}), "--strobe");
    EXPECT_EQ(Refusal(look, {1'000'000'000}), "--strobe");
}

} // namespace
} // namespace boxreel
