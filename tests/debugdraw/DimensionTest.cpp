// SPDX-License-Identifier: MIT
#include <debugdraw/Dimension.h>
#include <debugdraw/TextWidth.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

using namespace boxreel;
using testing::ElementsAre;

namespace
{

/// 64 x 36 m, the origin in the middle.
Camera View()
{
    Camera camera;
    camera.width = 640;
    camera.height = 360;
    camera.centerY = 0.0;
    camera.pixelsPerMeter = 10.0;
    return camera;
}

DrawList DimensionOf(Vec2 a, Vec2 b, const DimensionSettings& settings = {})
{
    DrawList list;
    AddDimension(list, View(), a, b, settings);
    return list;
}

/// Returns the tips of the arrow heads.
std::vector<Vec2> Tips(const DrawList& list)
{
    std::vector<Vec2> tips;
    for (const DrawItem& item : list.items)
    {
        if (item.kind == DrawKind::SolidPolygon)
        {
            tips.push_back(list.points[item.first]);
        }
    }
    return tips;
}

/// The middle of the text [px], y down.
Vec2 TextMiddle(const DrawList& list)
{
    const Vec2 corner = View().ToPixel(list.points[list.items.back().first]);
    return {corner.x + float(0.5 * TextWidth(list.texts.front())),
            corner.y + float(0.5 * kTextHeight)};
}

} // namespace

TEST(Dimension, ShowsDistanceAboveHorizontalPoints)
{
    const DrawList list = DimensionOf({-5, 0}, {7.5f, 0});
    EXPECT_THAT(list.texts, ElementsAre("12.5 m"));
    EXPECT_THAT(Tips(list), ElementsAre(Vec2{-5, 3}, Vec2{7.5f, 3})) << "30 px above";
    EXPECT_NEAR(TextMiddle(list).x, 332.5, 0.01);
    EXPECT_LT(TextMiddle(list).y, 150.0f - 7.5f);
    EXPECT_EQ(list.items.front().layer, DrawLayer::Annotations);
}

TEST(Dimension, IsLeftOfVerticalPoints)
{
    const DrawList list = DimensionOf({0, -5}, {0, 5});
    EXPECT_THAT(Tips(list), ElementsAre(Vec2{-3, -5}, Vec2{-3, 5}));
    EXPECT_LT(TextMiddle(list).x + 0.5 * TextWidth("10.0 m"), 290.0);
}

TEST(Dimension, IsOnTheOtherSideForNegativeOffset)
{
    DimensionSettings settings;
    settings.offset = -30.0;
    const DrawList list = DimensionOf({0, -5}, {0, 5}, settings);
    EXPECT_THAT(Tips(list), ElementsAre(Vec2{3, -5}, Vec2{3, 5}));
    EXPECT_GT(TextMiddle(list).x - 0.5 * TextWidth("10.0 m"), 350.0);
}

TEST(Dimension, HasOneShaftForBothArrows)
{
    const DrawList list = DimensionOf({-5, 0}, {5, 0});
    int level = 0;
    for (const DrawItem& item : list.items)
    {
        level += item.kind == DrawKind::Segment &&
                 list.points[item.first].y == list.points[item.first + 1].y;
    }
    EXPECT_EQ(level, 1);
}

TEST(Dimension, GoesToTheOtherSideAtTheEdgeOfThePicture)
{
    EXPECT_EQ(Tips(DimensionOf({-5, 16}, {5, 16})).front(), (Vec2{-5, 13}));
    EXPECT_EQ(Tips(DimensionOf({-30, -5}, {-30, 5})).front(), (Vec2{-27, -5}));
    // The text alone would have had room above.
    const std::vector<Vec2> slanted = Tips(DimensionOf({-20, -10}, {10, 17}));
    EXPECT_LT(slanted.at(1).y, 17.0f);
}

TEST(Dimension, HasArrowsOutsideWhenTheyDoNotFit)
{
    const DrawList list = DimensionOf({0, 0}, {1, 0});
    ASSERT_EQ(Tips(list).size(), 2u);
    EXPECT_EQ(Tips(list)[0], (Vec2{0, 3}));
    // The shaft of the first comes from the left.
    bool fromOutside = false;
    for (const DrawItem& item : list.items)
    {
        fromOutside |= item.kind == DrawKind::Segment && list.points[item.first].x < -1.0f;
    }
    EXPECT_TRUE(fromOutside);
}

TEST(Dimension, KeepsTextOffSlantedLineAndInPicture)
{
    for (int degrees = 0; degrees < 360; degrees += 7)
    {
        const float angle = float(degrees) * 0.0174533f;
        const Vec2 end{12.0f * std::cos(angle), 12.0f * std::sin(angle)};
        const DrawList list = DimensionOf({0, 0}, end);
        const std::vector<Vec2> tips = Tips(list);
        const Vec2 from = View().ToPixel(tips.at(0));
        const Vec2 middle = TextMiddle(list);
        const double normalX = -std::sin(angle);
        const double normalY = -std::cos(angle);
        const double away = std::abs((middle.x - from.x) * normalX + (middle.y - from.y) * normalY);
        const double reach = 0.5 * TextWidth(list.texts.front()) * std::abs(normalX) +
                             0.5 * kTextHeight * std::abs(normalY);
        EXPECT_GE(away, reach + 4.9) << degrees;
    }
    const DrawList atTheEdge = DimensionOf({-31.9f, -3}, {-31.4f, -3});
    EXPECT_GE(View().ToPixel(atTheEdge.points[atTheEdge.items.back().first]).x, 3.9f);
}

TEST(Dimension, MovesTextAlongItsLineOffOtherItems)
{
    DrawList list;
    list.AddSegment({0, -10}, {0, 10}, Color{}); // through where the text of the next would be
    AddDimension(list, View(), {-10, 0}, {10, 0});
    const Vec2 middle = TextMiddle(list);
    EXPECT_GT(std::abs(middle.x - 320.0), 0.5 * TextWidth("20.0 m"));
    EXPECT_LT(std::abs(middle.x - 320.0), 0.5 * TextWidth("20.0 m") + 24.0) << "and no farther";
    EXPECT_NEAR(middle.y, TextMiddle(DimensionOf({-10, 0}, {10, 0})).y, 0.01);
}

TEST(Dimension, KeepsTextInBodyWhoseOutlineItDoesNotTouch)
{
    DrawList list;
    const Vec2 corners[4] = {{-20, -10}, {20, -10}, {20, 10}, {-20, 10}};
    list.AddSolidPolygon(corners, 4, Color{});
    AddDimension(list, View(), {-10, 0}, {10, 0});
    EXPECT_NEAR(TextMiddle(list).x, 320.0, 0.5);
}

TEST(Dimension, ShowsTheGivenLabel)
{
    EXPECT_THAT(DimensionOf({0, 0}, {9, 0}, {.label = "L"}).texts, ElementsAre("L"));
}

TEST(Dimension, IsEmptyBetweenEqualPoints)
{
    EXPECT_TRUE(DimensionOf({1, 1}, {1, 1}).items.empty());
    EXPECT_TRUE(DimensionOf({1, 1}, {std::numeric_limits<float>::infinity(), 1}).items.empty());
}
