// SPDX-License-Identifier: MIT
#include "StaleTiles.h"

#include <gtest/gtest.h>

#include <random>

namespace boxreel
{
namespace
{

constexpr int kWidth = 75; // neither is a whole number of tiles
constexpr int kHeight = 50;

void Paint(Frame& frame, const PixelBounds& part, std::uint8_t value)
{
    for (int y = part.y0; y < part.y1; ++y)
    {
        for (int x = part.x0; x < part.x1; ++x)
        {
            frame.Pixel(x, y)[1] = value;
        }
    }
}

TEST(StaleTiles, FollowAFrameThatChangesBetweenCopies)
{
    std::mt19937 random(7);
    const auto below = [&random](int end) { return int(random() % unsigned(end)); };
    Frame original(kWidth, kHeight), copy;
    StaleTiles stale;
    for (int i = 0; i < 500; ++i)
    {
        for (int change = below(4); change > 0; --change)
        {
            const int left = below(kWidth), top = below(kHeight);
            const PixelBounds part{left, top, left + 1 + below(kWidth - left),
                                   top + 1 + below(kHeight - top)};
            Paint(original, part, std::uint8_t(below(256)));
            stale.Mark(part);
        }
        stale.BringUpToDate(original, copy);
        ASSERT_EQ(copy, original) << i;
    }
}

TEST(StaleTiles, CopyNothingThatIsUpToDate)
{
    Frame original(kWidth, kHeight), copy;
    StaleTiles stale;
    stale.BringUpToDate(original, copy);
    Paint(original, {0, 0, kWidth, kHeight}, 9);
    stale.Mark({70, 40, 71, 41});
    stale.BringUpToDate(original, copy);
    EXPECT_EQ(copy.Pixel(70, 40)[1], 9);
    EXPECT_EQ(copy.Pixel(0, 0)[1], 0) << "not marked as changed";
    EXPECT_EQ(copy.Pixel(63, 40)[1], 0) << "the next tile";
    Paint(original, {0, 0, kWidth, kHeight}, 17);
    stale.BringUpToDate(original, copy);
    EXPECT_EQ(copy.Pixel(70, 40)[1], 9);
}

TEST(StaleTiles, AcceptPartsBeyondTheFrame)
{
    Frame original(kWidth, kHeight), copy;
    StaleTiles stale;
    stale.Mark({-5, -5, 500, 500}); // before its size is known
    stale.BringUpToDate(original, copy);
    Paint(original, {0, 0, kWidth, kHeight}, 9);
    stale.Mark({-100, -100, kWidth + 100, kHeight + 100});
    stale.Mark({30, 30, 30, 20});
    stale.BringUpToDate(original, copy);
    EXPECT_EQ(copy, original);
}

} // namespace
} // namespace boxreel
