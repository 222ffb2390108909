// SPDX-License-Identifier: MIT
#include <scenes/Random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace boxreel
{
namespace
{

TEST(SceneRandom, GivesThePublishedNumbersOfSplitMix64)
{
    // The usual test vector of the algorithm, seed 1234567.
    Random random(1234567);
    EXPECT_EQ(random.Next(), 6457827717110365317u);
    EXPECT_EQ(random.Next(), 3203168211198807973u);
    EXPECT_EQ(random.Next(), 9817491932198370423u);
    EXPECT_EQ(random.Next(), 4593380528125082431u);
    EXPECT_EQ(random.Next(), 16408922859458223821u);
}

TEST(SceneRandom, StaysBetweenItsLimitsAndFillsTheRange)
{
    Random random(1);
    float32 lowest = 10.0f;
    float32 highest = -10.0f;
    float64 sum = 0.0;
    for (int32 i = 0; i < 10000; ++i)
    {
        const float32 value = random.Between(-2.0f, 4.0f);
        ASSERT_TRUE(-2.0f <= value && value < 4.0f);
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
        sum += static_cast<float64>(value);
    }
    EXPECT_LT(lowest, -1.99f);
    EXPECT_GT(highest, 3.99f);
    EXPECT_NEAR(sum / 10000.0, 1.0, 0.1); // five standard errors of the mean
}

TEST(SceneRandom, DrawsEachOfAFewWholeNumbersAboutEquallyOften)
{
    Random random(2);
    std::array<int32, 3> counts{};
    for (int32 i = 0; i < 3000; ++i)
    {
        const int32 drawn = random.Below(3);
        ASSERT_TRUE(0 <= drawn && drawn < 3);
        ++counts[static_cast<std::size_t>(drawn)];
    }
    for (int32 count : counts)
    {
        EXPECT_NEAR(count, 1000, 130); // five standard deviations
    }
}

} // namespace
} // namespace boxreel
