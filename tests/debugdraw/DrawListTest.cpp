// SPDX-License-Identifier: MIT
#include <debugdraw/DrawList.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ExampleList.h"

using namespace boxreel;

TEST(DrawList, KeepsPaintersOrderAndStampsLayerAndOwner)
{
    const DrawList list = ExampleList();
    ASSERT_EQ(list.items.size(), 8u);
    EXPECT_EQ(list.items[0].kind, DrawKind::SolidPolygon);
    EXPECT_EQ(list.items[0].owner, 3u);
    EXPECT_EQ(list.items[0].count, 4u);
    EXPECT_EQ(list.items[2].kind, DrawKind::Segment);
    EXPECT_EQ(list.items[2].layer, DrawLayer::Joints);
    EXPECT_EQ(list.items[2].owner, kNoOwner);
    EXPECT_EQ(list.points[list.items[2].first + 1], (Vec2{0.1f, -20.0f}));
}

TEST(DrawList, IsEqualWhenBuiltAlikeAndUnequalWhenAnythingDiffers)
{
    const DrawList list = ExampleList();
    EXPECT_EQ(list, ExampleList());
    DrawList moved = list;
    moved.points[5].x += 1e-6f;
    EXPECT_NE(list, moved);
    DrawList recolored = list;
    recolored.items[1].color.b ^= 1;
    EXPECT_NE(list, recolored);
    DrawList renamed = list;
    renamed.texts[0] += ' ';
    EXPECT_NE(list, renamed);
    DrawList reordered = list;
    std::swap(reordered.items[0], reordered.items[1]);
    EXPECT_NE(list, reordered);
}

TEST(DrawList, ComparesWhatIsDrawnNotWhatWouldBeStampedNext)
{
    DrawList list = ExampleList();
    list.layer = DrawLayer::Pairs;
    list.owner = 77;
    EXPECT_EQ(list, ExampleList());
}

TEST(DrawList, ClearsToAnEmptyListAndKeepsItsMemory)
{
    DrawList list = ExampleList();
    const auto items = list.items.capacity();
    const auto points = list.points.capacity();
    const auto texts = list.texts.capacity();
    const Vec2* storage = list.points.data();
    list.Clear();
    EXPECT_EQ(list, DrawList());
    EXPECT_EQ(list.layer, DrawLayer::Shapes);
    EXPECT_EQ(list.owner, kNoOwner);
    EXPECT_EQ(list.items.capacity(), items);
    EXPECT_EQ(list.points.capacity(), points);
    EXPECT_EQ(list.texts.capacity(), texts);
    FillExample(list);
    EXPECT_EQ(list.points.data(), storage);
    EXPECT_EQ(list, ExampleList());
}

TEST(Rect, IncludesPointsAndRectsAndIgnoresEmptyOnes)
{
    Rect rect;
    EXPECT_TRUE(rect.IsEmpty());
    rect.Include(Rect{});
    EXPECT_TRUE(rect.IsEmpty());
    rect.Include(Vec2{2.0f, -3.0f});
    EXPECT_FALSE(rect.IsEmpty());
    EXPECT_EQ(rect, (Rect{{2.0f, -3.0f}, {2.0f, -3.0f}}));
    rect.Include(Rect{{-1.0f, 0.0f}, {1.0f, 4.0f}});
    EXPECT_EQ(rect, (Rect{{-1.0f, -3.0f}, {2.0f, 4.0f}}));
    rect.Include(Rect{});
    EXPECT_EQ(rect, (Rect{{-1.0f, -3.0f}, {2.0f, 4.0f}}));
}

TEST(DrawList, FillsWhatEveryRendererCanFill)
{
    const auto kindOf = [](const std::vector<Vec2>& corners) {
        DrawList list;
        list.AddSolidPolygon(corners.data(), corners.size(), Color());
        return list.items.at(0).kind;
    };
    std::vector<Vec2> round;
    for (int i = 0; i < 17; ++i)
    {
        round.push_back({std::cos(0.37f * float(i)), std::sin(0.37f * float(i))});
    }
    EXPECT_EQ(kindOf(round), DrawKind::Polygon);
    round.pop_back();
    EXPECT_EQ(kindOf(round), DrawKind::SolidPolygon);
    const std::vector<Vec2> dented{{0, 0}, {4, 0}, {2, 1}, {4, 4}, {0, 4}};
    EXPECT_EQ(kindOf(dented), DrawKind::Polygon);
    EXPECT_EQ(kindOf({{0, 0}, {2, -1e-5f}, {4, 0}, {2, 3}}), DrawKind::SolidPolygon);
    EXPECT_EQ(kindOf({{0, 0}, {2, 1e-5f}, {4, 0}, {2, 3}}), DrawKind::SolidPolygon)
        << "rounding is no dent";
    EXPECT_EQ(kindOf({{2, 3}, {4, 0}, {0, 0}}), DrawKind::SolidPolygon) << "clockwise";
}
