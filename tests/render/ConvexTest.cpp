// SPDX-License-Identifier: MIT
#include "Convex.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace boxreel;

namespace
{

Convex Square(double half)
{
    const Point corners[4] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    return MakeConvex(corners, 4);
}

} // namespace

TEST(Convex, HasPositiveAreaInEitherDirection)
{
    const Point clockwise[3] = {{0, 0}, {0, 2}, {2, 0}};
    EXPECT_DOUBLE_EQ(MakeConvex(clockwise, 3).Area(), 2.0);
}

TEST(Convex, LosesRepeatedCornersAndFlatShapes)
{
    const Point repeated[5] = {{0, 0}, {0, 0}, {4, 0}, {4, 4}, {0, 0}};
    EXPECT_EQ(MakeConvex(repeated, 5).count, 3u);
    const Point line[3] = {{0, 0}, {1, 1}, {2, 2}};
    EXPECT_LT(MakeConvex(line, 3).count, 3u);
}

TEST(Convex, GrowsAndShrinksByTheDistance)
{
    EXPECT_NEAR(Grow(Square(3), 1).Area(), 64.0, 1e-9);
    EXPECT_NEAR(Shrink(Square(3), 1).Area(), 16.0, 1e-9);
    EXPECT_EQ(Shrink(Square(3), 3.01).count, 0u);
}

TEST(Convex, CutsOffSharpMitres)
{
    const Point sliver[3] = {{0, 0}, {100, -0.5}, {100, 0.5}};
    const Convex grown = Grow(MakeConvex(sliver, 3), 1.0);
    EXPECT_EQ(grown.count, 4u);
    for (std::size_t i = 0; i < grown.count; ++i)
    {
        EXPECT_GE(grown.corners[i].x, -kMitreLimit - 1e-9);
    }
    EXPECT_GT(grown.Area(), MakeConvex(sliver, 3).Area() + 200.0)
        << "about a unit on each long side";
}

TEST(Convex, LosesEdgesThatShrinkToNothing)
{
    // A square with a small corner cut off, shrunk past the cut.
    const Point corners[5] = {{0, 0}, {10, 0}, {10, 9.8}, {9.8, 10}, {0, 10}};
    const Convex rest = Shrink(MakeConvex(corners, 5), 2.0);
    EXPECT_EQ(rest.count, 4u);
    EXPECT_NEAR(rest.Area(), 36.0, 1e-9);
}

TEST(Convex, IsClippedToARectangle)
{
    const Convex clipped = Clip(Square(1000), {-5, -10}, {20, 10});
    EXPECT_NEAR(clipped.Area(), 25.0 * 20.0, 1e-9);
    EXPECT_EQ(Clip(Square(2), {5, 5}, {9, 9}).count, 0u);
}

TEST(Convex, FitsItsBoxToAnEdge)
{
    const double c = std::sqrt(0.5);
    const Point turned[4] = {{10 + 20 * c, 20 * c},
                             {10 - 20 * c, -20 * c},
                             {10 - 19 * c, -21 * c},
                             {10 + 21 * c, 19 * c}};
    const OrientedBox box = BoxAround(MakeConvex(turned, 4));
    EXPECT_NEAR(4.0 * box.half.x * box.half.y, MakeConvex(turned, 4).Area(), 1e-9);
    EXPECT_NEAR(InsideDistance(Square(3), {1, 0}), 2.0, 1e-12);
    EXPECT_LT(InsideDistance(Square(3), {4, 0}), 0.0);
}
