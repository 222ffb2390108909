// SPDX-License-Identifier: MIT
#include <debugdraw/Axes.h>
#include <debugdraw/Paper.h>
#include <debugdraw/ScaleBar.h>
#include <debugdraw/TextWidth.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

using namespace boxreel;
using testing::ElementsAre;

namespace
{

Camera View(double pixelsPerMeter, double centerX = 0.0, double centerY = 0.0)
{
    Camera camera;
    camera.width = 640;
    camera.height = 360;
    camera.centerX = centerX;
    camera.centerY = centerY;
    camera.pixelsPerMeter = pixelsPerMeter;
    return camera;
}

const Camera kPaper = PaperCamera(900, 500);

DrawList AxesOf(const Camera& view)
{
    DrawList list;
    AddAxes(list, kPaper, view, {100, 20});
    return list;
}

/// The position of a text item: left, right, top [px of paper].
struct Placed
{
    double left, right, top;
};

std::vector<Placed> PlacedTexts(const DrawList& list)
{
    std::vector<Placed> placed;
    for (const DrawItem& item : list.items)
    {
        if (item.kind == DrawKind::Text)
        {
            const Vec2 p = list.points[item.first];
            placed.push_back({p.x, p.x + TextWidth(list.texts[item.text]), -p.y});
        }
    }
    return placed;
}

} // namespace

TEST(Axes, HaveTicksAtNiceSteps)
{
    EXPECT_THAT(Ticks(-1.2, 1.1, 0.5), ElementsAre(-1.0, -0.5, 0.0, 0.5, 1.0));
    EXPECT_THAT(Ticks(0.0, 4.0, 2.0), ElementsAre(0.0, 2.0, 4.0));
    EXPECT_TRUE(Ticks(0.1, 0.9, 1.0).empty());
    const DrawList list = AxesOf(View(40.0)); // 16 m x 9 m
    EXPECT_THAT(list.texts, ElementsAre("-8", "-6", "-4", "-2", "0", "2", "4", "6 m", "8", "-4",
                                        "-2", "0", "2", "4 m"));
    for (const DrawItem& item : list.items)
    {
        EXPECT_EQ(item.layer, DrawLayer::Annotations);
    }
}

TEST(Axes, CentreNumbersAtTheirTicks)
{
    int units = 0;
    for (double zoom = 0.3; zoom < 3000.0; zoom *= 1.23)
    {
        const DrawList list = AxesOf(View(zoom, -12.3, 5.7));
        double tickX = 0.0;
        double tickY = 0.0;
        for (const DrawItem& item : list.items)
        {
            const Vec2 p = list.points[item.first];
            if (item.kind == DrawKind::Segment)
            {
                tickX = p.x;
                tickY = -p.y;
                continue;
            }
            const std::string& text = list.texts[item.text];
            const std::string number = text.substr(0, text.find(' '));
            const bool isBelow = -p.y > 385.0;
            units += number != text ? 1 : 0;
            EXPECT_NEAR(isBelow ? p.x + 0.5 * TextWidth(number) - tickX
                                : -p.y + 0.5 * kTextHeight - tickY,
                        0.0, 1e-3)
                << text << " at " << zoom;
            EXPECT_LE(p.x + TextWidth(text), 740.0 + kAxisOver);
            EXPECT_GE(-p.y, 20.0 - kAxisOver);
        }
    }
    EXPECT_EQ(units % 2, 0) << "one an axis";
    EXPECT_GT(units, 60);
}

TEST(Axes, HideNothingOfThePicture)
{
    for (const double zoom : {0.01, 3.0, 40.0, 77.0, 1500.0, 99999.0})
    {
        const DrawList list = AxesOf(View(zoom, 12.3, -4.5));
        for (const Vec2 p : list.points)
        {
            EXPECT_TRUE(p.x < 99.01f || -p.y > 380.99f) << p.x << ", " << -p.y;
        }
    }
}

TEST(Axes, KeepNumbersApartAndInTheirMargin)
{
    for (double zoom = 0.01; zoom < 30000.0; zoom *= 1.37)
    {
        const Camera view = View(zoom, -123.4, 57.0);
        double right = -1e9;
        for (const Placed& text : PlacedTexts(AxesOf(view)))
        {
            if (text.top > 380.0) // the axis below
            {
                EXPECT_GE(text.left, right + 6.0) << zoom;
                EXPECT_LE(text.top + kTextHeight, 380.0 + kAxisBelow);
                right = text.right;
            }
            else
            {
                EXPECT_GE(text.left, 100.0 - RoomForAxis(view)) << zoom;
            }
        }
    }
}

TEST(Axes, AreEmptyForInvalidViews)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Camera& view :
         {View(0.0), View(-1.0), View(nan), View(1e300), View(1e-300), View(10.0, nan),
          View(10.0, 0.0, nan), View(10.0, 0.0, 1e300), View(10.0, 1e15)})
    {
        EXPECT_TRUE(AxesOf(view).items.empty());
        EXPECT_EQ(RoomForAxis(view), 0);
    }
    for (const double zoom : {0.0, -1.0, nan, 1e300, 1e-300})
    {
        DrawList list;
        AddScaleBar(list, kPaper, zoom, {10, 400}, 200.0);
        EXPECT_TRUE(list.items.empty()) << zoom;
    }
}

TEST(OriginMark, LiesAtTheOrigin)
{
    DrawList list;
    AddOriginMark(list, View(40.0, 3.0, 2.0));
    ASSERT_EQ(list.items.size(), 3u);
    EXPECT_EQ(list.items[2].kind, DrawKind::Circle);
    EXPECT_NEAR(list.points[list.items[2].first].x, 0.0, 1e-5);
    EXPECT_NEAR(list.points[list.items[2].first].y, 0.0, 1e-5);
}

TEST(ScaleBar, IsOmittedWithoutRoomForItsText)
{
    const Camera tiny = PaperCamera(31, 60); // a bar of 10 px and 7 px of room for "2 m"
    DrawList list;
    AddScaleBar(list, tiny, 5.0, {12, 50}, 20.0);
    EXPECT_TRUE(list.items.empty());
    AddScaleBar(list, PaperCamera(80, 60), 5.0, {12, 50}, 20.0);
    EXPECT_THAT(list.texts, ElementsAre("2 m"));
}

TEST(ScaleBar, HasTheLengthOfItsText)
{
    for (const auto& [zoom, text] :
         {std::pair{40.0, "2 m"}, std::pair{3.0, "20 m"}, std::pair{1000.0, "0.1 m"}})
    {
        DrawList list;
        AddScaleBar(list, kPaper, zoom, {10, 400}, 200.0);
        EXPECT_THAT(list.texts, ElementsAre(text));
        const double pixels = list.points[1].x - list.points[0].x;
        EXPECT_NEAR(pixels, zoom * std::stod(text), 1e-3);
        EXPECT_GE(pixels, 40.0);
        EXPECT_LE(pixels, 100.0);
    }
}
