// SPDX-License-Identifier: MIT
#include <session/SceneCamera.h>

#include <gmock/gmock.h>

#include <cmath>

namespace boxreel
{
namespace
{

constexpr double kStep = 1.0 / 60.0;        // [s]
constexpr double kRoundingInAColumn = 1e-3; // [px]

struct SceneCameraFixture : testing::Test
{
    b2Body* Add(float x, float y, float half, b2BodyType type = b2_kinematicBody)
    {
        b2BodyDef definition;
        definition.type = type;
        definition.position.Set(x, y);
        b2Body* body = world.CreateBody(&definition);
        b2PolygonShape box;
        box.SetAsBox(half, half);
        body->CreateFixture(&box, 1.0f);
        return body;
    }

    SceneCamera Camera(const ViewChoice& choice)
    {
        Result<SceneCamera> camera = SceneCamera::Create(choice, world, 1280, 720);
        EXPECT_TRUE(camera) << camera.GetError().Text();
        return *camera;
    }

    std::string Refusal(const ViewChoice& choice)
    {
        const Result<SceneCamera> camera = SceneCamera::Create(choice, world, 1280, 720);
        return camera ? "accepted" : camera.GetError().culprit;
    }

    void StepFor(double seconds, SceneCamera& camera)
    {
        for (int step = 0; step < std::lround(seconds / kStep); ++step)
        {
            world.Step(float(kStep), 8, 3);
            time += kStep;
            camera.Update(world, time, kStep);
        }
    }

    static bool Shows(const boxreel::Camera& view, const b2Body& body, float half)
    {
        const Rect area = view.VisibleArea();
        const b2Vec2 p = body.GetPosition();
        return p.x - half > area.lower.x && p.x + half < area.upper.x &&
               p.y - half > area.lower.y && p.y + half < area.upper.y;
    }

    b2World world{b2Vec2(0.0f, -10.0f)};
    double time = 0.0;
};

using SceneCameraTest = SceneCameraFixture;

TEST_F(SceneCameraTest, FollowsTheBodyOfGivenNumber)
{
    Add(-30.0f, 0.0f, 1.0f);
    b2Body* runner = Add(5.0f, 7.0f, 1.0f);
    Add(60.0f, 0.0f, 1.0f);
    SceneCamera camera = Camera(FollowView{{1}, 12.0});
    EXPECT_EQ(camera.View().centerX, 5.0);
    EXPECT_EQ(camera.View().centerY, 7.0);
    EXPECT_EQ(camera.View().pixelsPerMeter, 60.0);
    runner->SetLinearVelocity(b2Vec2(4.0f, 0.0f));
    StepFor(2.0, camera);
    EXPECT_GT(camera.View().centerX, 11.0);
    EXPECT_LT(camera.View().centerX, runner->GetPosition().x);
    EXPECT_EQ(camera.View().centerY, 7.0);
    EXPECT_EQ(camera.View().pixelsPerMeter, 60.0);
}

TEST_F(SceneCameraTest, FollowsTheMiddleOfSeveral)
{
    Add(-10.0f, 0.0f, 1.0f);
    Add(0.0f, 8.0f, 1.0f);
    Add(20.0f, 4.0f, 3.0f);
    const SceneCamera camera = Camera(FollowView{{2, 0}, 40.0});
    EXPECT_EQ(camera.View().centerX, 5.0);
    EXPECT_EQ(camera.View().centerY, 2.0);
}

TEST_F(SceneCameraTest, FollowsAtAHeightThatSuitsTheBodiesByDefault)
{
    Add(0.0f, 0.0f, 0.5f);
    b2Body* large = Add(40.0f, 0.0f, 10.0f);
    EXPECT_DOUBLE_EQ(Camera(FollowView{{0}, std::nullopt}).View().pixelsPerMeter, 72.0);
    const SceneCamera camera = Camera(FollowView{{1}, std::nullopt});
    EXPECT_TRUE(Shows(camera.View(), *large, 29.0f)) << "a third of the frame";
    EXPECT_FALSE(Shows(camera.View(), *large, 31.0f));
}

TEST_F(SceneCameraTest, IgnoresTwitchOfTwoCentimetres)
{
    b2Body* body = Add(3.0f, 4.0f, 0.5f);
    for (const ViewChoice& choice :
         {ViewChoice(FollowView{{0}, 10.0}), ViewChoice(FitBodiesView{{0}})})
    {
        body->SetTransform(b2Vec2(3.0f, 4.0f), 0.0f);
        SceneCamera camera = Camera(choice);
        const boxreel::Camera start = camera.View();
        for (int step = 0; step < 200; ++step)
        {
            const float way = step % 2 == 0 ? 0.02f : -0.02f;
            body->SetTransform(b2Vec2(3.0f + way, 4.0f - way), 0.0f);
            camera.Update(world, step * kStep, kStep);
            ASSERT_EQ(camera.View(), start);
        }
    }
}

TEST_F(SceneCameraTest, KeepsFittedBodiesInViewHoweverFarTheyGo)
{
    Add(0.0f, 0.0f, 100.0f, b2_staticBody);
    b2Body* left = Add(-3.0f, 200.0f, 1.0f);
    b2Body* right = Add(3.0f, 200.0f, 1.0f);
    SceneCamera camera = Camera(FitBodiesView{{1, 2}});
    const double start = camera.View().pixelsPerMeter;
    EXPECT_TRUE(Shows(camera.View(), *left, 1.0f) && Shows(camera.View(), *right, 1.0f));
    EXPECT_GT(start, 50.0) << "and nothing else is fitted";
    right->SetLinearVelocity(b2Vec2(20.0f, 3.0f));
    for (int i = 0; i < 100; ++i)
    {
        StepFor(0.1, camera);
        ASSERT_TRUE(Shows(camera.View(), *left, 0.99f) && Shows(camera.View(), *right, 0.99f));
    }
    EXPECT_LT(camera.View().pixelsPerMeter, 0.1 * start);
}

TEST_F(SceneCameraTest, FitsWhatIsDrawnBesideBodies)
{
    Add(0.0f, 0.0f, 1.0f);
    const auto shows = [](const boxreel::Camera& view, const b2AABB& box) {
        const double halfHeight = 0.5 * view.height / view.pixelsPerMeter;
        const double halfWidth = 0.5 * view.width / view.pixelsPerMeter;
        return box.lowerBound.x > view.centerX - halfWidth &&
               box.upperBound.x < view.centerX + halfWidth &&
               box.lowerBound.y > view.centerY - halfHeight &&
               box.upperBound.y < view.centerY + halfHeight;
    };
    b2AABB picture;
    picture.lowerBound.Set(-30.0f, -10.0f);
    picture.upperBound.Set(40.0f, 20.0f);
    for (const ViewChoice& choice : {ViewChoice(FitView{false}), ViewChoice(SceneView())})
    {
        Result<SceneCamera> camera =
            SceneCamera::Create(choice, world, 1280, 720, false, {picture});
        ASSERT_TRUE(camera);
        EXPECT_TRUE(shows(camera->View(), picture));
        const boxreel::Camera before = camera->View();
        camera->Update(world, kStep, kStep, {picture});
        EXPECT_EQ(camera->View(), before) << "it is in view already";
        picture.upperBound.x += 10.0f; // it moves with its body
        for (int i = 0; i < 60; ++i)
        {
            camera->Update(world, kStep, kStep, {picture});
            ASSERT_TRUE(shows(camera->View(), picture)) << i;
        }
    }
}

TEST_F(SceneCameraTest, ShowsStaticBodiesWhenWholeWorldIsFitted)
{
    b2Body* ground = Add(0.0f, -300.0f, 250.0f, b2_staticBody);
    b2Body* ball = Add(0.0f, 5.0f, 1.0f);
    EXPECT_FALSE(Shows(Camera(FitView{false}).View(), *ground, 250.0f));
    const SceneCamera camera = Camera(FitView{true});
    EXPECT_TRUE(Shows(camera.View(), *ground, 250.0f));
    EXPECT_TRUE(Shows(camera.View(), *ball, 1.0f));
}

TEST_F(SceneCameraTest, FollowsPathBySimulatedTime)
{
    const PathView path{{{1.0, 0.0, 0.0, 50.0}, {3.0, 10.0, 0.0, 50.0}}};
    SceneCamera camera = Camera(path);
    EXPECT_EQ(camera.View().centerX, 0.0);
    camera.Update(world, 2.0, kStep);
    EXPECT_NEAR(camera.View().centerX * 14.4, 5.0 * 14.4, kRoundingInAColumn);
    camera.Update(world, 100.0, kStep);
    EXPECT_EQ(camera.View().centerX, 10.0);
}

TEST_F(SceneCameraTest, RefusesUnknownBody)
{
    EXPECT_EQ(Refusal(FollowView{{0}, 5.0}), "--camera 0");
    Add(0.0f, 0.0f, 1.0f);
    EXPECT_EQ(Refusal(FollowView{{1}, 5.0}), "--camera 1");
    Add(0.0f, 0.0f, 1.0f);
    EXPECT_EQ(Refusal(FollowView{{1}, 5.0}), "accepted");
    EXPECT_EQ(Refusal(FitBodiesView{{0, 2}}), "--camera 2");
}

TEST_F(SceneCameraTest, ShowsLaterBodyOnceItExists)
{
    Add(0.0f, 0.0f, 1.0f);
    const SceneCamera all = Camera(FitView{});
    for (const ViewChoice& choice :
         {ViewChoice(FollowView{{1}, 12.0}), ViewChoice(FitBodiesView{{1}})})
    {
        Result<SceneCamera> camera = SceneCamera::Create(choice, world, 1280, 720, true);
        ASSERT_TRUE(camera);
        EXPECT_EQ(camera->View(), all.View()) << "what there is, until then";
        EXPECT_FALSE(camera->CheckBodiesCame());
    }
    Result<SceneCamera> camera = SceneCamera::Create(FollowView{{1}, 12.0}, world, 1280, 720, true);
    ASSERT_TRUE(camera);
    Add(30.0f, 5.0f, 1.0f);
    camera->Update(world, kStep, kStep);
    EXPECT_TRUE(camera->CheckBodiesCame());
    EXPECT_EQ(camera->View().centerX, 30.0);
    EXPECT_EQ(camera->View().pixelsPerMeter, 60.0);
}

TEST_F(SceneCameraTest, ShowsTheOthersWhenABodyIsDestroyed)
{
    b2Body* gone = Add(0.0f, 0.0f, 1.0f);
    Add(20.0f, 0.0f, 1.0f);
    Add(90.0f, 0.0f, 1.0f);
    SceneCamera camera = Camera(FollowView{{0, 1}, 40.0});
    EXPECT_EQ(camera.View().centerX, 10.0);
    world.DestroyBody(gone);
    StepFor(3.0, camera);
    EXPECT_NEAR(camera.View().centerX, 20.0, 0.04 * 40.0 + 1e-3) << "up to the calm zone";
    const boxreel::Camera last = camera.View();
    world.DestroyBody(world.GetBodyList()->GetNext());
    StepFor(1.0, camera);
    EXPECT_EQ(camera.View(), last) << "when none is left";
}

} // namespace
} // namespace boxreel
