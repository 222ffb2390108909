// SPDX-License-Identifier: MIT
#include "GifRate.h"
#include "VideoFormat.h"

#include <gtest/gtest.h>

#include <vector>

namespace boxreel
{
namespace
{

/// Delays as GifFilm writes them, for frames with these numbers; the last is the end.
std::vector<std::int64_t> DelaysBetween(const std::vector<std::int64_t>& frames,
                                        const Rational& rate)
{
    std::vector<std::int64_t> delays;
    for (std::size_t i = 1; i < frames.size(); ++i)
    {
        delays.push_back(GifTimeOfFrame(frames[i], rate) - GifTimeOfFrame(frames[i - 1], rate));
    }
    return delays;
}

std::vector<std::int64_t> Numbers(std::int64_t first, std::int64_t count)
{
    std::vector<std::int64_t> numbers;
    for (std::int64_t i = 0; i <= count; ++i)
    {
        numbers.push_back(first + i);
    }
    return numbers;
}

TEST(GifRate, EqualsRateOfFilmDespiteRoundedDelays)
{
    for (const Rational& rate : {Rational{10, 1}, Rational{24, 1}, Rational{25, 1}, Rational{30, 1},
                                 Rational{50, 1}, Rational{30000, 1001}, Rational{25, 2}})
    {
        EXPECT_EQ(RateOfGif(DelaysBetween(Numbers(0, 300), rate)), rate)
            << rate.num << "/" << rate.den;
    }
}

TEST(GifRate, CountsAHeldFrameAsSeveral)
{
    const std::vector<std::int64_t> frames = {0, 1, 2, 3, 40, 41, 42, 43, 44, 90, 91};
    EXPECT_EQ(RateOfGif(DelaysBetween(frames, {30, 1})), (Rational{30, 1}));
}

TEST(GifRate, EqualsRateOfFilmForALaterPart)
{
    EXPECT_EQ(RateOfGif(DelaysBetween(Numbers(1001, 200), {30, 1})), (Rational{30, 1}));
}

TEST(GifRate, IsTheMeanWhenNoUsualRateFits)
{
    const Rational rate = RateOfGif(DelaysBetween(Numbers(0, 400), {2345, 100}));
    constexpr double kRoundedEnd =
        0.5 * 23.45 / (100.0 * 400 / 23.45); // half a hundredth at the end
    EXPECT_NEAR(rate.ToDouble(), 23.45, kRoundedEnd);
}

TEST(GifRate, IsDerivedFromTheDelayOfASingleFrame)
{
    EXPECT_EQ(RateOfGif(std::vector<std::int64_t>{4}), (Rational{25, 1}));
}

} // namespace
} // namespace boxreel
