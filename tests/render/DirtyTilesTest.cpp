// SPDX-License-Identifier: MIT
#include "DirtyTiles.h"

#include <gtest/gtest.h>

#include <random>

using namespace boxreel;

namespace
{

bool Holds(const std::vector<PixelBounds>& rectangles, int x, int y)
{
    int holders = 0;
    for (const PixelBounds& r : rectangles)
    {
        holders += x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1;
    }
    EXPECT_LE(holders, 1) << x << ", " << y;
    return holders == 1;
}

} // namespace

TEST(DirtyTiles, CoverAddedPixelsOnceInPicture)
{
    std::mt19937 random(5);
    const auto below = [&](int maximum) { return int(random() % unsigned(maximum)); };
    for (int round = 0; round < 200; ++round)
    {
        const int width = 1 + below(150);
        const int height = 1 + below(90);
        DirtyTiles tiles(width, height);
        std::vector<PixelBounds> added;
        for (int i = below(12); i > 0; --i)
        {
            const int x = below(width);
            const int y = below(height);
            added.push_back(
                {x, y, std::min(width, x + 1 + below(40)), std::min(height, y + 1 + below(40))});
            tiles.Add(added.back());
        }
        std::vector<PixelBounds> rectangles;
        tiles.Gather(below(9), rectangles);
        for (const PixelBounds& r : rectangles)
        {
            EXPECT_EQ(Intersection(r, {0, 0, width, height}), r);
            EXPECT_TRUE(tiles.Touches(r));
        }
        for (const PixelBounds& r : added)
        {
            for (int y = r.y0; y < r.y1; ++y)
            {
                for (int x = r.x0; x < r.x1; ++x)
                {
                    ASSERT_TRUE(Holds(rectangles, x, y)) << x << ", " << y;
                    ASSERT_TRUE(tiles.Touches({x, y, x + 1, y + 1}));
                }
            }
        }
        tiles.Clear();
        EXPECT_TRUE(tiles.IsEmpty());
        EXPECT_FALSE(tiles.Touches({0, 0, width, height}));
        tiles.Gather(1, rectangles);
        EXPECT_TRUE(rectangles.empty());
    }
}

TEST(DirtyTiles, ExcludePixelsFarFromAddedOnes)
{
    DirtyTiles tiles(1280, 720);
    tiles.Add({100, 100, 120, 130});
    tiles.Add({900, 500, 910, 505});
    std::vector<PixelBounds> rectangles;
    tiles.Gather(2, rectangles);
    ASSERT_EQ(rectangles.size(), 2u);
    EXPECT_LE(rectangles[0].Area(), 32 * 40);
    EXPECT_FALSE(tiles.Touches({500, 100, 600, 600}));
}

TEST(DirtyTiles, CoverTheWholePictureForTooManyPieces)
{
    DirtyTiles tiles(2000, 2000);
    for (int y = 0; y < 2000; y += 40)
    {
        for (int x = 0; x < 2000; x += 40)
        {
            tiles.Add({x, y, x + 1, y + 1});
        }
    }
    std::vector<PixelBounds> rectangles;
    tiles.Gather(1, rectangles);
    EXPECT_EQ(rectangles, (std::vector<PixelBounds>{{0, 0, 2000, 2000}}));
}
