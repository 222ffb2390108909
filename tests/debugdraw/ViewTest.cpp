// SPDX-License-Identifier: MIT
#include <debugdraw/View.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace boxreel;

namespace
{

/// 20 m x 10 m around (100, 50), 10 px a metre.
Camera SomeCamera()
{
    return {.width = 200, .height = 100, .centerX = 100.0, .centerY = 50.0, .pixelsPerMeter = 10.0};
}

} // namespace

TEST(View, ShowsWhatReachesIntoThePictureAndItsMargin)
{
    const View view = ViewOf(SomeCamera(), 5.0); // half a metre
    EXPECT_TRUE(view.Shows(Vec2{100.0f, 50.0f}));
    EXPECT_TRUE(view.Shows(Vec2{110.45f, 50.0f}));
    EXPECT_FALSE(view.Shows(Vec2{110.55f, 50.0f}));
    EXPECT_FALSE(view.Shows(Vec2{89.45f, 50.0f}));
    EXPECT_FALSE(view.Shows(Vec2{100.0f, 55.55f}));
    EXPECT_FALSE(view.Shows(Vec2{100.0f, 44.45f}));
    EXPECT_TRUE(view.Shows(Vec2{0.0f, 50.0f}, Vec2{500.0f, 50.0f})) << "across it";
    EXPECT_TRUE(view.Shows(Rect{{0.0f, 0.0f}, {500.0f, 500.0f}})) << "around it";
}

TEST(View, CountsPixelsBesideAPoint)
{
    const View view = ViewOf(SomeCamera(), 0.0);
    EXPECT_TRUE(view.Shows(Vec2{111.0f, 50.0f}, 11.0));
    EXPECT_FALSE(view.Shows(Vec2{111.0f, 50.0f}, 9.0));
    EXPECT_TRUE(view.Shows(Vec2{100.0f, 44.0f}, Vec2{100.0f, 43.0f}, 11.0));
    EXPECT_FALSE(view.Shows(Vec2{100.0f, 44.0f}, Vec2{100.0f, 43.0f}, 9.0));
}

TEST(ViewOfEverything, ShowsEverything)
{
    EXPECT_TRUE(ViewOfEverything(SomeCamera()).Shows(Vec2{-1e30f, 1e30f}));
}

TEST(View, OmitsNothingWhereFloatsAreCoarse)
{
    Camera camera = SomeCamera();
    camera.centerX = 16'777'217.0; // no float; 2 m apart they are there
    camera.pixelsPerMeter = 1000.0;
    const View view = ViewOf(camera, 0.0);
    EXPECT_TRUE(view.Shows(Vec2{16'777'216.0f, 50.0f}));
    EXPECT_TRUE(view.Shows(Vec2{16'777'218.0f, 50.0f}));
}
