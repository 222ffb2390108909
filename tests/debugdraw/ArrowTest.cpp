// SPDX-License-Identifier: MIT
#include <debugdraw/Arrow.h>

#include <gtest/gtest.h>

#include <limits>

using namespace boxreel;

namespace
{

const Color kInk{255, 255, 255, 255};

Camera TenPixelsAMeter()
{
    Camera camera;
    camera.pixelsPerMeter = 10.0;
    return camera;
}

DrawList ArrowOf(const Camera& camera, Vec2 tail, Vec2 tip)
{
    DrawList list;
    AddArrow(list, camera, tail, tip, kInk, {.length = 10.0, .halfWidth = 4.0});
    return list;
}

} // namespace

TEST(Arrow, HasAShaftThatEndsWhereItsHeadBegins)
{
    const DrawList list = ArrowOf(TenPixelsAMeter(), {1.0f, 2.0f}, {6.0f, 2.0f});
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_EQ(list.items[0].kind, DrawKind::Segment);
    EXPECT_EQ(list.points[0], (Vec2{1.0f, 2.0f}));
    EXPECT_EQ(list.points[1], (Vec2{5.0f, 2.0f}));
    EXPECT_EQ(list.items[1].kind, DrawKind::SolidPolygon);
    EXPECT_EQ(list.points[2], (Vec2{6.0f, 2.0f}));
    EXPECT_EQ(list.points[3], (Vec2{5.0f, 2.4f}));
    EXPECT_EQ(list.points[4], (Vec2{5.0f, 1.6f}));
}

TEST(Arrow, HasThreeStrokesWithAnOpenHead)
{
    DrawList list;
    AddArrow(list, TenPixelsAMeter(), {1.0f, 2.0f}, {6.0f, 2.0f}, kInk,
             {.length = 10.0, .halfWidth = 4.0, .open = true});
    ASSERT_EQ(list.items.size(), 3u);
    for (std::size_t stroke = 0; stroke < 3; ++stroke)
    {
        EXPECT_EQ(list.items[stroke].kind, DrawKind::Segment);
        EXPECT_EQ(list.points[2 * stroke + 1], (Vec2{6.0f, 2.0f}));
    }
    EXPECT_EQ(list.points[0], (Vec2{1.0f, 2.0f}));
    EXPECT_EQ(list.points[2], (Vec2{5.0f, 2.4f}));
    EXPECT_EQ(list.points[4], (Vec2{5.0f, 1.6f}));
}

TEST(Arrow, HasAHeadOfTheSamePixelsInEveryView)
{
    Camera near = TenPixelsAMeter();
    near.pixelsPerMeter = 100.0;
    const DrawList list = ArrowOf(near, {0.0f, 0.0f}, {0.0f, 1.0f});
    ASSERT_EQ(list.items.size(), 2u);
    EXPECT_FLOAT_EQ(list.points[1].y, 0.9f);
}

TEST(Arrow, HasASmallerHeadAndNoShaftWhereItIsShort)
{
    const DrawList list = ArrowOf(TenPixelsAMeter(), {0.0f, 0.0f}, {0.5f, 0.0f});
    ASSERT_EQ(list.items.size(), 1u);
    EXPECT_FLOAT_EQ(list.points[1].x, 0.0f);
    EXPECT_FLOAT_EQ(list.points[1].y, 0.2f);
}

TEST(Arrow, IsEmptyWithoutLength)
{
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(ArrowOf(TenPixelsAMeter(), {1.0f, 1.0f}, {1.0f, 1.0f}).items.empty());
    EXPECT_TRUE(ArrowOf(TenPixelsAMeter(), {1.0f, 1.0f}, {infinity, 1.0f}).items.empty());
    EXPECT_TRUE(ArrowOf(TenPixelsAMeter(), {nan, 1.0f}, {1.0f, 1.0f}).items.empty());
}
