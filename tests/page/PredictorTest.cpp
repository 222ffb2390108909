// SPDX-License-Identifier: MIT
#include "Predictor.h"

#include <gtest/gtest.h>

namespace boxreel
{
namespace
{

std::int64_t MissAfter(const std::vector<std::int64_t>& numbers, std::int64_t next)
{
    Predictor predictor;
    for (const std::int64_t number : numbers)
    {
        predictor.Add(number);
    }
    return next - predictor.Guess();
}

TEST(Predictor, PredictsRestSpeedAndAcceleration)
{
    EXPECT_TRUE(Predictor().IsEmpty());
    EXPECT_EQ(MissAfter({5}, 5), 0);
    EXPECT_EQ(MissAfter({5, 5, 5, 5}, 5), 0);
    EXPECT_EQ(MissAfter({10, 20, 30, 40}, 50), 0);
    EXPECT_EQ(MissAfter({0, 1, 4, 9, 16, 25, 36}, 49), 0);
}

TEST(Predictor, PredictsNoChangeForAlternatingNumbers)
{
    // The other rules would guess twice and four times as far off.
    EXPECT_EQ(MissAfter({0, 8, 0, 8, 0, 8, 0, 8}, 0), -8);
}

TEST(Column, PutsSmallNumbersInOneByte)
{
    Column column;
    column.Put(0);
    column.Put(-1);
    column.Put(123);
    column.Put(-124);
    EXPECT_EQ(column.small, std::string({0, 1, char(246), char(247)}));
    EXPECT_EQ(column.large, "");
}

TEST(Column, PutsLargeNumbersInAsManyBytesAsTheyNeed)
{
    Column column;
    column.Put(124);
    column.Put(-0x1234);
    EXPECT_EQ(column.small, std::string({char(0xf8), char(0xf9)}));
    EXPECT_EQ(column.large, std::string({char(248), char(0x67), char(0x24)}));
}

} // namespace
} // namespace boxreel
