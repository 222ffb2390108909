// SPDX-License-Identifier: MIT
#include <debugdraw/Camera.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace boxreel;

namespace
{

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

// Both directions pass through a float each. The one of world coordinates is weighted by the
// pixels.
double RoundingInPixels(const Camera& camera, Vec2 world)
{
    const double metres = std::abs(double(world.x)) + std::abs(double(world.y)) + 1.0;
    return 1e-7 * (metres * camera.pixelsPerMeter + camera.width + camera.height);
}

// From a float to the next one away from zero.
double Spacing(float x)
{
    return double(std::nextafter(std::abs(x), kInfinity)) - std::abs(x);
}

bool IsInside(const Rect& inner, const Rect& outer, double slack)
{
    return inner.lower.x >= outer.lower.x - slack && inner.lower.y >= outer.lower.y - slack &&
           inner.upper.x <= outer.upper.x + slack && inner.upper.y <= outer.upper.y + slack;
}

} // namespace

TEST(Camera, ShowsFiftyMetresAroundTheTestbedsCentreByDefault)
{
    const Camera camera;
    EXPECT_EQ(camera.ToPixel({0.0f, 20.0f}), (Vec2{640.0f, 360.0f}));
    EXPECT_EQ(camera.ToPixel({0.0f, 45.0f}), (Vec2{640.0f, 0.0f}));
    EXPECT_EQ(camera.ToPixel({0.0f, -5.0f}), (Vec2{640.0f, 720.0f}));
    EXPECT_LT(camera.ToPixel({-1.0f, 20.0f}).x, 640.0f);
}

TEST(Camera, IsExactAtTheCentreOfEveryPixel)
{
    Camera camera;
    camera.width = 101;
    camera.height = 57;
    camera.centerX = 3.25;
    camera.centerY = -8.5;
    camera.pixelsPerMeter = 16.0; // pixels lie on numbers that a float holds
    for (int y = 0; y < camera.height; ++y)
    {
        for (int x = 0; x < camera.width; ++x)
        {
            const Vec2 center{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            const Vec2 world = camera.ToWorld(center);
            EXPECT_EQ(double(world.x), 3.25 + (x + 0.5 - 50.5) / 16.0);
            EXPECT_EQ(double(world.y), -8.5 - (y + 0.5 - 28.5) / 16.0);
            EXPECT_EQ(camera.ToPixel(world), center);
        }
    }
}

TEST(Camera, MapsPixelsAndMetresBackAndForth)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 5000; ++i)
    {
        Camera camera;
        camera.width = 1 + int(random() % 8192);
        camera.height = 1 + int(random() % 8192);
        camera.centerX = 500.0 * unit(random);
        camera.centerY = 500.0 * unit(random);
        camera.pixelsPerMeter = 50.5 + 50.0 * unit(random);
        const Vec2 pixel{static_cast<float>(random() % unsigned(camera.width)) + 0.5f,
                         static_cast<float>(random() % unsigned(camera.height)) + 0.5f};
        const Vec2 world = camera.ToWorld(pixel);
        const Vec2 again = camera.ToPixel(world);
        const double rounding = RoundingInPixels(camera, world);
        EXPECT_NEAR(again.x, pixel.x, rounding);
        EXPECT_NEAR(again.y, pixel.y, rounding);
    }
}

TEST(Camera, MapsEveryPixelToWorldAndBackAtAnySize)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const int sizes[][2] = {{1, 1}, {33, 17}, {1, 8192}, {8191, 4321}, {8192, 8192}};
    for (const auto& [width, height] : sizes)
    {
        int checked = 0;
        for (int i = 0; i < 2000; ++i)
        {
            Camera camera;
            camera.width = width;
            camera.height = height;
            camera.centerX = std::pow(10.0, 3.0 * unit(random)) * unit(random);
            camera.centerY = std::pow(10.0, 3.0 * unit(random)) * unit(random);
            camera.pixelsPerMeter = std::pow(10.0, 1.0 + 2.0 * unit(random));
            const Vec2 pixel{static_cast<float>(random() % unsigned(width)) + 0.5f,
                             static_cast<float>(random() % unsigned(height)) + 0.5f};
            const Vec2 world = camera.ToWorld(pixel);
            const double errorX = 0.5 * Spacing(world.x) * camera.pixelsPerMeter;
            const double errorY = 0.5 * Spacing(world.y) * camera.pixelsPerMeter;
            if (std::max(errorX, errorY) > 0.25)
            {
                continue;
            }
            ++checked;
            const Vec2 again = camera.ToPixel(world);
            // Rounded once in each direction, to the nearest; there is no other loss.
            EXPECT_NEAR(again.x, pixel.x, errorX + 0.5 * Spacing(pixel.x) + 1e-9);
            EXPECT_NEAR(again.y, pixel.y, errorY + 0.5 * Spacing(pixel.y) + 1e-9);
            EXPECT_EQ(std::floor(again.x), std::floor(pixel.x));
            EXPECT_EQ(std::floor(again.y), std::floor(pixel.y));
        }
        EXPECT_GT(checked, 1900);
    }
}

TEST(Camera, CentersOnMiddlePixelWhenSizeIsOdd)
{
    const int sizes[][2] = {{1, 1}, {33, 17}, {8191, 4321}};
    for (const auto& [width, height] : sizes)
    {
        Camera camera;
        camera.width = width;
        camera.height = height;
        camera.centerX = 0.1f;
        camera.centerY = -7.3f;
        camera.pixelsPerMeter = height / 3.7;
        const Vec2 middle{static_cast<float>(width / 2) + 0.5f,
                          static_cast<float>(height / 2) + 0.5f};
        EXPECT_EQ(camera.ToPixel({0.1f, -7.3f}), middle);
        EXPECT_EQ(camera.ToWorld(middle), (Vec2{0.1f, -7.3f}));
    }
}

TEST(Camera, SeesExactlyTheRectBetweenItsCorners)
{
    Camera camera;
    camera.width = 640;
    camera.height = 320;
    camera.centerX = 1.0;
    camera.centerY = 2.0;
    camera.pixelsPerMeter = 32.0;
    EXPECT_EQ(camera.VisibleArea(), (Rect{{-9.0f, -3.0f}, {11.0f, 7.0f}}));
}

TEST(FitTo, ShowsTheWholeAreaWithItsMargin)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int i = 0; i < 2000; ++i)
    {
        const Vec2 corner{200.0f * unit(random) - 100.0f, 200.0f * unit(random) - 100.0f};
        const Rect area{
            corner,
            {corner.x + 1.0f + 90.0f * unit(random), corner.y + 1.0f + 90.0f * unit(random)}};
        const int width = 16 + int(random() % 2000);
        const int height = 16 + int(random() % 2000);
        const double margin = 0.4 * unit(random);
        const Camera camera = FitTo(area, width, height, margin);
        const Vec2 topLeft = camera.ToPixel({area.lower.x, area.upper.y});
        const Vec2 bottomRight = camera.ToPixel({area.upper.x, area.lower.y});
        const double border = margin * std::min(width, height);
        const double left = topLeft.x - border;
        const double top = topLeft.y - border;
        EXPECT_GE(left, -1e-2);
        EXPECT_GE(top, -1e-2);
        EXPECT_NEAR(std::min(left, top), 0.0, 1e-2) << "no closer than needed";
        EXPECT_NEAR(left, width - border - bottomRight.x, 1e-2) << "in the middle";
        EXPECT_NEAR(top, height - border - bottomRight.y, 1e-2) << "in the middle";
    }
}

TEST(FitTo, UsesDefaultViewForInvalidArea)
{
    const Camera standard;
    for (const Rect& area :
         {Rect{}, Rect{{kNoNumber, 0.0f}, {1.0f, 1.0f}}, Rect{{0.0f, 0.0f}, {kNoNumber, 1.0f}},
          Rect{{0.0f, 0.0f}, {kInfinity, 1.0f}}, Rect{{0.0f, 2.0f}, {1.0f, 1.0f}}})
    {
        EXPECT_EQ(FitTo(area, 1280, 720), standard);
    }
    EXPECT_DOUBLE_EQ(FitTo(Rect{}, 100, 100).pixelsPerMeter, 2.0);
}

TEST(FitTo, ShowsAPointAndALineInAViewOfUsefulSize)
{
    const Camera point = FitTo({{7.0f, -3.0f}, {7.0f, -3.0f}}, 1000, 500, 0.1);
    EXPECT_EQ(point.ToPixel({7.0f, -3.0f}), (Vec2{500.0f, 250.0f}));
    EXPECT_DOUBLE_EQ(point.pixelsPerMeter, 400.0);
    const Camera line = FitTo({{-10.0f, 0.0f}, {10.0f, 0.0f}}, 1000, 500, 0.1);
    EXPECT_DOUBLE_EQ(line.pixelsPerMeter, 45.0);
}

TEST(FitTo, StaysFiniteForTheLargestArea)
{
    const float maximum = std::numeric_limits<float>::max();
    const Camera camera = FitTo({{-maximum, -maximum}, {maximum, maximum}}, 1280, 720);
    EXPECT_GT(camera.pixelsPerMeter, 0.0);
    EXPECT_TRUE(std::isfinite(camera.centerX) && std::isfinite(camera.centerY));
    EXPECT_TRUE(IsInside({{0.0f, 0.0f}, {0.0f, 0.0f}}, camera.VisibleArea(), 0.0));
}

TEST(Camera, InterpolatesCentreAndHeightOfTwoViews)
{
    const Camera from{.centerX = 0.0, .centerY = 10.0, .pixelsPerMeter = 10.0};
    const Camera to{.centerX = 4.0, .centerY = 10.0, .pixelsPerMeter = 20.0};
    const Camera between = Between(from, to, 0.25);
    EXPECT_DOUBLE_EQ(between.centerX, 1.0);
    EXPECT_EQ(between.centerY, 10.0);
    const double height = 0.75 / 10.0 + 0.25 / 20.0; // of a pixel [m]
    EXPECT_DOUBLE_EQ(between.pixelsPerMeter, 1.0 / height);
    EXPECT_EQ(Between(to, to, 0.3), to);
}
