// SPDX-License-Identifier: MIT
#include <debugdraw/Box2d24Draw.h>
#include <debugdraw/DrawListText.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>

using namespace boxreel;

namespace
{

struct Box2d24Draw : testing::Test
{
    DrawList list;
    box2d24::DrawCollector collector{list};

    Color Of(const b2Color& color)
    {
        list.Clear();
        collector.DrawCircle({0.0f, 0.0f}, 1.0f, color);
        return list.items.at(0).color;
    }
};

/// A world of that library in which every layer has something to draw: a ball on a
/// pivot, and a box that touches the floor.
struct Box2d24World : testing::Test
{
    b2World world{b2Vec2(0.0f, -10.0f)};

    Box2d24World()
    {
        b2BodyDef body;
        b2Body* const ground = world.CreateBody(&body);
        b2EdgeShape floor;
        floor.SetTwoSided(b2Vec2(-5.0f, 0.0f), b2Vec2(5.0f, 0.0f));
        ground->CreateFixture(&floor, 0.0f);
        body.type = b2_dynamicBody;
        body.position.Set(-2.0f, 0.5f);
        b2PolygonShape box;
        box.SetAsBox(0.5f, 0.5f);
        world.CreateBody(&body)->CreateFixture(&box, 1.0f);
        body.position.Set(2.0f, 3.0f);
        b2CircleShape round;
        round.m_radius = 0.25f;
        b2Body* const ball = world.CreateBody(&body);
        ball->CreateFixture(&round, 1.0f);
        b2RevoluteJointDef pivot;
        pivot.Initialize(ground, ball, b2Vec2(3.0f, 3.0f));
        world.CreateJoint(&pivot);
        world.Step(1.0f / 60.0f, 8, 3);
    }

    std::map<DrawLayer, int> LayersOf(uint32 flags)
    {
        std::map<DrawLayer, int> counts;
        for (const DrawItem& item : box2d24::DrawListOf(world, flags).items)
        {
            ++counts[item.layer];
        }
        return counts;
    }
};

constexpr uint32 kEverything = 0x1f;

} // namespace

TEST_F(Box2d24Draw, CollectsTheItemsOfEachCall)
{
    const b2Vec2 triangle[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}};
    b2Transform xf;
    xf.Set(b2Vec2(4.0f, 5.0f), 0.0f);
    const b2Color color(1.0f, 0.5f, 0.0f);
    collector.DrawPolygon(triangle, 3, color);
    collector.DrawSolidPolygon(triangle, 3, color);
    collector.DrawCircle({1.0f, 2.0f}, 3.0f, color);
    collector.DrawSolidCircle({1.0f, 2.0f}, 3.0f, {0.0f, 1.0f}, color);
    collector.DrawSegment({1.0f, 2.0f}, {3.0f, 4.0f}, color);
    collector.DrawTransform(xf);
    collector.DrawPoint({7.0f, 8.0f}, 4.0f, color);
    DrawList expected;
    const Vec2 same[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}};
    const Color orange{255, 128, 0, 255};
    expected.AddPolygon(same, 3, orange);
    expected.AddSolidPolygon(same, 3, orange);
    expected.AddCircle({1.0f, 2.0f}, 3.0f, orange);
    expected.AddSolidCircle({1.0f, 2.0f}, 3.0f, {0.0f, 1.0f}, orange);
    expected.AddSegment({1.0f, 2.0f}, {3.0f, 4.0f}, orange);
    expected.AddTransform({4.0f, 5.0f}, {1.0f, 0.0f}, 0.4f);
    expected.AddPoint({7.0f, 8.0f}, 4.0f, orange);
    EXPECT_EQ(ToText(list), ToText(expected));
}

TEST_F(Box2d24Draw, GivesItemsLayerAndOwnerOfTheList)
{
    list.layer = DrawLayer::Scene;
    list.owner = 7;
    collector.DrawSegment({0.0f, 0.0f}, {1.0f, 0.0f}, b2Color(1.0f, 1.0f, 1.0f));
    EXPECT_EQ(list.items.at(0).layer, DrawLayer::Scene);
    EXPECT_EQ(list.items.at(0).owner, 7u);
}

TEST_F(Box2d24Draw, DrawsPolygonsOfTwoCornersAsSegments)
{
    const b2Vec2 line[2] = {{0.0f, 0.0f}, {1.0f, 0.0f}};
    collector.DrawPolygon(line, 2, b2Color(1.0f, 1.0f, 1.0f));
    collector.DrawSolidPolygon(line, 2, b2Color(1.0f, 1.0f, 1.0f));
    collector.DrawPolygon(line, 0, b2Color(1.0f, 1.0f, 1.0f));
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_EQ(list.items[0].kind, DrawKind::Segment);
    EXPECT_EQ(list.items[1].kind, DrawKind::Segment);
}

TEST_F(Box2d24Draw, ClampsColoursToTheirRange)
{
    const float none = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(Of(b2Color(2.0f, -1.0f, none, 0.25f)), (Color{255, 0, 0, 64}));
}

TEST_F(Box2d24World, IsDrawnLayerByLayer)
{
    const std::map<DrawLayer, int> counts = LayersOf(kEverything);
    EXPECT_EQ(counts.at(DrawLayer::CentersOfMass), 3);
    EXPECT_EQ(counts.at(DrawLayer::Aabbs), 3) << "one for each fixture";
    EXPECT_EQ(counts.at(DrawLayer::Pairs), 1) << "of the box and the floor";
    EXPECT_GE(counts.at(DrawLayer::Joints), 3);
    EXPECT_GE(counts.at(DrawLayer::Shapes), 3);
}

TEST_F(Box2d24World, ShowsOnlyTheGivenLayers)
{
    EXPECT_THAT(LayersOf(b2Draw::e_aabbBit),
                testing::ElementsAre(testing::Pair(DrawLayer::Aabbs, 3)));
    EXPECT_TRUE(box2d24::DrawListOf(world, 0).items.empty());
    const DrawList usual = box2d24::DrawListOf(world);
    EXPECT_EQ(usual, box2d24::DrawListOf(world, b2Draw::e_shapeBit | b2Draw::e_jointBit));
    EXPECT_FALSE(usual.items.empty());
}

TEST_F(Box2d24World, IsDrawnAsInOneCall)
{
    DrawList list;
    box2d24::DrawCollector collector(list);
    collector.SetFlags(kEverything);
    world.SetDebugDraw(&collector);
    world.DebugDraw();
    const DrawList layers = box2d24::DrawListOf(world, kEverything);
    EXPECT_EQ(layers.points, list.points) << "the same covers the same";
    EXPECT_EQ(layers.items.size(), list.items.size());
}

TEST_F(Box2d24World, HasNoDebugDrawingRegisteredAfterwards)
{
    {
        DrawList list;
        box2d24::DrawCollector collector(list);
        world.SetDebugDraw(&collector);
        (void)box2d24::DrawListOf(world);
    }
    world.DebugDraw(); // would call what is gone
    EXPECT_EQ(box2d24::DrawListOf(world).owner, kNoOwner);
}
