// SPDX-License-Identifier: MIT
#include <Box2D/Box2D.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/DrawListText.h>

#include <gtest/gtest.h>

#include <limits>

using namespace boxreel;

namespace
{

struct CollectedItems : testing::Test
{
    DrawList list;
    DrawCollector collector{list};

    Color Of(const b2Color& color)
    {
        list.Clear();
        collector.DrawCircle({0.0f, 0.0f}, 1.0f, color);
        return list.items.at(0).color;
    }
};

const b2Vec2 kOctagonAndMore[9] = {{3.0f, 0.0f},  {2.0f, 2.0f},   {0.0f, 3.0f},
                                   {-2.0f, 2.0f}, {-3.0f, 0.0f},  {-2.0f, -2.0f},
                                   {0.0f, -3.0f}, {1.0f, -2.75f}, {2.0f, -2.0f}};

} // namespace

TEST_F(CollectedItems, AreThoseOfTheCalls)
{
    const b2Vec2 triangle[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}};
    b2Transform xf;
    xf.Set(b2Vec2(4.0f, 5.0f), 0.0f);
    collector.BeginLayer(b2Draw::e_shapeBit);
    collector.BeginBody(2);
    collector.DrawSolidPolygon(triangle, 3, b2Color(0.9f, 0.7f, 0.7f));
    collector.DrawSolidCircle({1.0f, 2.0f}, 0.5f, {0.0f, 1.0f}, b2Color(0.5f, 0.9f, 0.5f));
    collector.DrawCircle({1.0f, 2.0f}, 0.5f, b2Color(0.5f, 0.5f, 0.9f));
    collector.BeginBody(-1);
    collector.BeginLayer(b2Draw::e_jointBit);
    collector.DrawSegment({0.0f, 1.0f}, {2.0f, 3.0f}, b2Color(0.5f, 0.8f, 0.8f));
    collector.BeginLayer(b2Draw::e_pairBit);
    collector.DrawSegment({0.0f, 1.0f}, {2.0f, 3.0f}, b2Color(0.3f, 0.9f, 0.9f));
    collector.BeginLayer(b2Draw::e_aabbBit);
    collector.DrawPolygon(triangle, 3, b2Color(0.9f, 0.3f, 0.9f));
    collector.BeginLayer(b2Draw::e_centerOfMassBit);
    collector.BeginBody(0);
    collector.DrawTransform(xf);
    EXPECT_EQ(ToText(list), "body 2 shapes solid-polygon #e6b3b3 (0, 0) (1, 0) (0, 1)\n"
                            "body 2 shapes solid-circle #80e680 (1, 2) (0, 1) radius 0.5\n"
                            "body 2 shapes circle #8080e6 (1, 2) radius 0.5\n"
                            "world joints segment #80cccc (0, 1) (2, 3)\n"
                            "world pairs segment #4de6e6 (0, 1) (2, 3)\n"
                            "world aabbs polygon #e64de6 (0, 0) (1, 0) (0, 1)\n"
                            "body 0 centers-of-mass transform #ffffff (4, 5) (1, 0) axes 0.4\n");
    std::vector<ColorRole> roles;
    for (const DrawItem& item : list.items)
    {
        roles.push_back(item.role);
    }
    EXPECT_EQ(roles,
              (std::vector{ColorRole::AwakeBody, ColorRole::StaticBody, ColorRole::KinematicBody,
                           ColorRole::Joint, ColorRole::Pair, ColorRole::Aabb, ColorRole::None}));
}

TEST_F(CollectedItems, HaveNoRoleForColoursOfAUser)
{
    const b2Color likeStatic(0.5f, 0.9f, 0.5f);
    collector.DrawSegment({0.0f, 1.0f}, {2.0f, 3.0f}, likeStatic);
    list.layer = DrawLayer::Scene;
    collector.DrawSegment({0.0f, 1.0f}, {2.0f, 3.0f}, likeStatic);
    collector.BeginLayer(b2Draw::e_jointBit);
    collector.DrawSegment({0.0f, 1.0f}, {2.0f, 3.0f}, likeStatic);
    for (const DrawItem& item : list.items)
    {
        EXPECT_EQ(item.Asked(), Paint(128, 230, 128));
    }
}

TEST_F(CollectedItems, HaveRolesOfTheAnnouncedLayer)
{
    const b2Color likeJoint(0.5f, 0.8f, 0.8f);
    list.layer = DrawLayer::Scene;
    collector.DrawSegment({0.0f, 1.0f}, {2.0f, 3.0f}, likeJoint);
    collector.BeginLayer(b2Draw::e_jointBit);
    collector.DrawSegment({0.0f, 1.0f}, {2.0f, 3.0f}, likeJoint);
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_EQ(list.items[0].role, ColorRole::None);
    EXPECT_EQ(list.items[1].role, ColorRole::Joint);
    EXPECT_EQ(list.items[1].layer, DrawLayer::Scene);
}

TEST_F(CollectedItems, HaveColoursRoundedAndClamped)
{
    EXPECT_EQ(Of(b2Color(0.9f, 0.7f, 0.5f, 0.3f)), (Color{230, 179, 128, 77}));
    EXPECT_EQ(Of(b2Color(0.0f, 1.0f, 1.0f)), (Color{0, 255, 255, 255}));
    EXPECT_EQ(Of(b2Color(-1.0f, 2.0f, 1e30f, -1e30f)), (Color{0, 255, 255, 0}));
    EXPECT_EQ(Of(b2Color(std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f)),
              (Color{0, 0, 0, 255}));
    for (int step = 0; step < 256; ++step)
    {
        EXPECT_EQ(Of(b2Color(static_cast<float>(step) / 255.0f, 0.0f, 0.0f)).r, step);
    }
}

TEST_F(CollectedItems, AreFilledForAtMostEightCorners)
{
    collector.DrawSolidPolygon(kOctagonAndMore, 8, b2Color(1.0f, 1.0f, 1.0f));
    collector.DrawSolidPolygon(kOctagonAndMore, 9, b2Color(1.0f, 1.0f, 1.0f));
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_EQ(list.items[0].kind, DrawKind::SolidPolygon);
    EXPECT_EQ(list.items[0].count, 8u);
    EXPECT_EQ(list.items[1].kind, DrawKind::Polygon);
    EXPECT_EQ(list.items[1].count, 9u);
    EXPECT_EQ(list.points.back(), (Vec2{2.0f, -2.0f}));
}

TEST_F(CollectedItems, AreSegmentsOrNothingForFewCorners)
{
    collector.DrawPolygon(kOctagonAndMore, 0, b2Color(1.0f, 1.0f, 1.0f));
    collector.DrawSolidPolygon(kOctagonAndMore, 0, b2Color(1.0f, 1.0f, 1.0f));
    EXPECT_TRUE(list.items.empty());
    collector.DrawSolidPolygon(kOctagonAndMore, 1, b2Color(1.0f, 1.0f, 1.0f));
    collector.DrawPolygon(kOctagonAndMore, 2, b2Color(1.0f, 1.0f, 1.0f));
    EXPECT_EQ(ToText(list), "world shapes segment #ffffff (3, 0) (3, 0)\n"
                            "world shapes segment #ffffff (3, 0) (2, 2)\n");
}

TEST_F(CollectedItems, AreOnlyThoseThatTheViewMayShow)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2CircleShape ball;
    ball.m_radius = 0.5f;
    for (const float x : {0.0f, 5.35f, 9.0f})
    {
        b2BodyDef definition;
        definition.position.Set(x, 0.0f);
        world.CreateBody(&definition)->CreateFixture(&ball, 1.0f);
    }
    Camera camera{.width = 100, .height = 100, .centerY = 0.0, .pixelsPerMeter = 10.0};
    const auto draw = [&] {
        list.Clear();
        collector.SetFlags(b2Draw::e_centerOfMassBit);
        world.SetDebugDraw(&collector);
        world.DrawDebugData();
        return list.items.size();
    };
    EXPECT_EQ(draw(), 3u);
    collector.LookAt(ViewOf(camera, 2.0)); // to 5 m, and an axis is 0.4 m long
    EXPECT_EQ(draw(), 2u);
    collector.LookAt(ViewOfEverything(camera));
    EXPECT_EQ(draw(), 3u);
}
