// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

#include <gtest/gtest.h>

// Scenes whose bodies and joints change while they play.
namespace boxreel
{
namespace
{

TEST(WebScene, BearsLightPebblesAndTearsUnderHeavyOnes)
{
    const auto scene = Make("Web");
    const std::size_t whole = JointsOf<b2DistanceJoint>(*scene).size();
    EXPECT_EQ(whole, 12u * 5u * 2u + 12u);
    Play(*scene, 3.0f);
    EXPECT_EQ(JointsOf<b2DistanceJoint>(*scene).size(), whole) << "two pebbles are borne";
    Play(*scene, 9.0f);
    const std::size_t left = JointsOf<b2DistanceJoint>(*scene).size();
    EXPECT_LT(left, whole - 3);
    EXPECT_GT(left, whole / 2) << "most of it holds";
    EXPECT_EQ(scene->Describe()[1].second, std::to_string(whole - left));
}

TEST(WebScene, TearsWhereTheMousePulls)
{
    const auto scene = Make("Web");
    Play(*scene, 0.5f);
    const std::size_t before = JointsOf<b2DistanceJoint>(*scene).size();
    const b2Body* knot = Movers(*scene)[5];
    scene->MouseDown(knot->GetPosition());
    for (float32 way = 0.0f; way < 8.0f; way += 0.1f)
    {
        scene->MouseMove(b2Vec2(0.0f, 10.0f - way));
        Play(*scene, 0.02f);
    }
    EXPECT_LT(JointsOf<b2DistanceJoint>(*scene).size(), before);
}

TEST(WebScene, LosesAThreadAndAKnotByKeys)
{
    const auto scene = Make("Web");
    const std::size_t threads = JointsOf<b2DistanceJoint>(*scene).size();
    const std::size_t knots = Movers(*scene).size();
    scene->KeyDown('j');
    EXPECT_EQ(JointsOf<b2DistanceJoint>(*scene).size(), threads - 1);
    scene->KeyDown('b');
    EXPECT_EQ(Movers(*scene).size(), knots - 1);
}

TEST(BodyTypesScene, MovesPlatformAsItsTypeAllows)
{
    const auto scene = Make("Body Types");
    scene->KeyDown('s');
    const auto* slide = JointsOf<b2PrismaticJoint>(*scene)[0];
    const b2Body* platform = slide->GetBodyB();
    const float32 start = platform->GetPosition().x;
    Play(*scene, 2.0f);
    EXPECT_EQ(platform->GetPosition().x, start) << "static";

    scene->KeyDown('k');
    Play(*scene, 2.0f);
    EXPECT_NEAR(platform->GetPosition().x, start + 4.0f, 0.01f) << "kinematic, with crates on it";

    scene->KeyDown('d');
    float32 fastest = 0.0f;
    Play(*scene, 4.0f, [&] { fastest = std::max(fastest, platform->GetLinearVelocity().x); });
    EXPECT_GT(fastest, 2.2f) << "dynamic, pushed by the ball";
    EXPECT_NEAR(platform->GetPosition().y, 6.0f, 0.01f) << "the slide holds it up";
}

TEST(BodyTypesScene, ChangesTypesByItself)
{
    const auto scene = Make("Body Types");
    std::string types;
    Play(*scene, 10.0f, [&] {
        const char first = scene->Describe()[0].second[0];
        if (types.empty() || types.back() != first)
        {
            types += first;
        }
    });
    EXPECT_EQ(types, "ksdk");
}

TEST(BreakableScene, BreaksOnceWithoutLosingMass)
{
    const auto scene = Make("Breakable");
    ASSERT_EQ(Movers(*scene).size(), 1u);
    const float32 mass = Movers(*scene)[0]->GetMass();
    Play(*scene, 1.0f);
    EXPECT_EQ(Movers(*scene).size(), 1u) << "whole in the air";
    Play(*scene, 4.0f);
    const std::vector<b2Body*> parts = Movers(*scene);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_NEAR(parts[0]->GetMass() + parts[1]->GetMass(), mass, 1e-4f);
    for (const b2Body* part : parts)
    {
        EXPECT_NEAR(part->GetWorldCenter().y, 0.5f, 0.03f) << "each lies on the ground";
    }
    EXPECT_GT(b2Distance(parts[0]->GetWorldCenter(), parts[1]->GetWorldCenter()), 2.5f);
}

TEST(BreakableScene, StaysWholeWhenItIsPutDownSoftly)
{
    const auto scene = Make("Breakable");
    b2Body* beam = Movers(*scene)[0];
    beam->SetTransform(b2Vec2(6.0f, 0.6f), 0.0f);
    Play(*scene, 3.0f);
    EXPECT_EQ(Movers(*scene).size(), 1u);
}

} // namespace
} // namespace boxreel
