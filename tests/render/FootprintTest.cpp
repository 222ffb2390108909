// SPDX-License-Identifier: MIT
#include "Footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace boxreel;

namespace
{

constexpr int kSize = 100;
constexpr PixelBounds kPicture{0, 0, kSize, kSize};

/// Within 0.71 px of it, which is as far as coverage reaches.
bool Touches(ProgramKind kind, const std::vector<float>& a, int x, int y)
{
    const double dx = x + 0.5 - a[0];
    const double dy = y + 0.5 - a[1];
    const double along = std::abs(dx * a[2] + dy * a[3]);
    const double across = std::abs(dy * a[2] - dx * a[3]);
    switch (kind)
    {
    case ProgramKind::Disc:
        return std::hypot(dx, dy) < a[5] + 0.71;
    case ProgramKind::Capsule:
        return std::hypot(std::max(along - a[4], 0.0), across) < a[5] + 0.71;
    default:
        return along < a[4] + 0.71 && across < a[5] + 0.71;
    }
}

} // namespace

TEST(Footprint, HoldsEveryPixelThatAShapeTouches)
{
    std::mt19937 random(4);
    const auto between = [&random](double a, double b) {
        return float(a + (b - a) * double(random()) / 4294967296.0);
    };
    for (int round = 0; round < 300; ++round)
    {
        const ProgramKind kind = round % 3 == 0   ? ProgramKind::Disc
                                 : round % 3 == 1 ? ProgramKind::Capsule
                                                  : ProgramKind::Box;
        const double angle = round % 5 == 0 ? 0.0 : between(0.0, 6.3);
        const std::vector<float> shape{between(-10, 110),      between(-10, 110),
                                       float(std::cos(angle)), float(std::sin(angle)),
                                       between(0.1, 40.0),     between(0.1, 20.0)};
        const Footprint footprint(kind, kPicture, shape);
        const int rows = 1 + round % 4;
        for (int y = 0; y < kSize; ++y)
        {
            const int y0 = y / rows * rows;
            const Footprint::Span span = footprint.Between(y0, y0 + rows);
            for (int x = 0; x < kSize; ++x)
            {
                ASSERT_TRUE(!Touches(kind, shape, x, y) || (span.x0 <= x && x < span.x1))
                    << "shape " << round << " at " << x << ", " << y;
            }
        }
    }
}

TEST(Footprint, ExcludesMostOfTheBoundsOfASlantedShape)
{
    const std::vector<float> line{50.0f, 50.0f, 0.70710678f, 0.70710678f, 60.0f, 1.0f};
    const Footprint footprint(ProgramKind::Box, kPicture, line);
    int pixels = 0;
    for (int y = 0; y < kSize; ++y)
    {
        const Footprint::Span span = footprint.Between(y, y + 1);
        pixels += std::max(span.x1 - span.x0, 0);
    }
    EXPECT_LT(pixels, kSize * 10);
}

TEST(Footprint, FillsTheBoundsForGlyphs)
{
    const Footprint::Span span = Footprint(ProgramKind::Glyph, {3, 4, 30, 40}, {}).Between(10, 12);
    EXPECT_EQ(span.x0, 3);
    EXPECT_EQ(span.x1, 30);
}
