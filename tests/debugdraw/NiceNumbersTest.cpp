// SPDX-License-Identifier: MIT
#include <debugdraw/NiceNumbers.h>

#include <gtest/gtest.h>

using namespace boxreel;

TEST(NiceNumbers, AreOneTwoAndFiveTimesAPowerOfTen)
{
    EXPECT_EQ(NiceBelow(1.0), 1.0);
    EXPECT_EQ(NiceBelow(1.99), 1.0);
    EXPECT_EQ(NiceBelow(4.9), 2.0);
    EXPECT_EQ(NiceBelow(7.0), 5.0);
    EXPECT_EQ(NiceBelow(0.3), 0.2);
    EXPECT_EQ(NiceBelow(123456.0), 100000.0);
    EXPECT_EQ(NiceAbove(1.0), 1.0);
    EXPECT_EQ(NiceAbove(1.01), 2.0);
    EXPECT_EQ(NiceAbove(0.03), 0.05);
    EXPECT_EQ(NiceAbove(51.0), 100.0);
    EXPECT_EQ(NiceAbove(0.1 + 0.2), 0.5);
    EXPECT_EQ(NiceAbove(3.0 * 0.1 - 0.1), 0.2) << "rounding is no reason for the next one";
}

TEST(NiceNumbers, AreWrittenWithTheDecimalsTheyNeed)
{
    EXPECT_EQ(NumberBy(20.0, 10.0), "20");
    EXPECT_EQ(NumberBy(-1.5, 0.5), "-1.5");
    EXPECT_EQ(NumberBy(2.0, 0.5), "2.0");
    EXPECT_EQ(NumberBy(0.15, 0.05), "0.15");
    EXPECT_EQ(NumberBy(-1e-17, 0.5), "0.0");
    EXPECT_EQ(NumberMeasured(0.125), "0.125");
    EXPECT_EQ(NumberMeasured(1.2), "1.20");
    EXPECT_EQ(NumberMeasured(12.34), "12.3");
    EXPECT_EQ(NumberMeasured(123.4), "123");
    EXPECT_EQ(NumberMeasured(0.01234), "0.0123");
    EXPECT_EQ(NumberMeasured(0.0), "0.00");
    EXPECT_EQ(NumberPlain(2.0), "2");
    EXPECT_EQ(NumberPlain(0.5), "0.5");
    EXPECT_EQ(NumberPlain(1.0 / 60.0), "0.017");
    EXPECT_EQ(NumberPlain(100.0), "100");
}
