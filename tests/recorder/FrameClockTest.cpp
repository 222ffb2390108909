// SPDX-License-Identifier: MIT
#include <recorder/FrameClock.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace
{

using boxreel::ErrorKind;
using boxreel::FrameClock;
using boxreel::Rational;
using boxreel::Result;

Rational Parsed(const char* text)
{
    const Result<Rational> parsed = Rational::Parse(text);
    EXPECT_TRUE(parsed) << text << ": " << (parsed ? "" : parsed.GetError().Text());
    return parsed ? *parsed : Rational{};
}

TEST(Rational, KeepsDecimalsAndFractionsExactlyInLowestTerms)
{
    EXPECT_EQ(Parsed("60"), (Rational{60, 1}));
    EXPECT_EQ(Parsed("29.97"), (Rational{2997, 100}));
    EXPECT_EQ(Parsed("0.25"), (Rational{1, 4}));
    EXPECT_EQ(Parsed(".5"), (Rational{1, 2}));
    EXPECT_EQ(Parsed("30000/1001"), (Rational{30000, 1001}));
    EXPECT_EQ(Parsed("120/2"), (Rational{60, 1}));
    EXPECT_EQ(Parsed("1.000000000"), (Rational{1, 1}));
    EXPECT_EQ(Parsed("000000060.50"), (Rational{121, 2}));
    EXPECT_EQ(Parsed("0.000000001"), (Rational{1, 1'000'000'000}));
    EXPECT_EQ(Parsed("999999999/999999998"), (Rational{999'999'999, 999'999'998}));
}

TEST(Rational, RefusesTextThatIsNoPositiveNumber)
{
    for (const char* text : {"0",
                             "0.0",
                             "-1",
                             "-0.5",
                             "0/5",
                             "5/0",
                             "nan",
                             "NaN",
                             "inf",
                             "1e3",
                             "abc",
                             "1.",
                             ".",
                             "/",
                             "1/",
                             "/2",
                             "1/2/3",
                             "1.2.3",
                             "1.5/2",
                             " 60",
                             "60 ",
                             "+60",
                             "0x10",
                             "1,5",
                             "1234567890",
                             "0.1234567890",
                             "1/1234567890",
                             "123456789.123456789"})
    {
        const Result<Rational> parsed = Rational::Parse(text);
        ASSERT_FALSE(parsed) << text;
        EXPECT_EQ(parsed.GetError().kind, ErrorKind::Unusable) << text;
        EXPECT_EQ(parsed.GetError().culprit, "'" + std::string(text) + "'");
    }
}

TEST(Rational, RefusesAnEmptyTextAndShortensALongOne)
{
    ASSERT_FALSE(Rational::Parse(""));
    EXPECT_EQ(Rational::Parse("").GetError().culprit, "number");
    const Result<Rational> parsed = Rational::Parse(std::string(100000, '9'));
    ASSERT_FALSE(parsed);
    EXPECT_LT(parsed.GetError().Text().size(), 200u);
}

TEST(FrameClock, ShowsOneStepAFrameByDefault)
{
    const FrameClock clock;
    for (std::int64_t frame : {0, 1, 59, 600, 1'000'000'000})
    {
        EXPECT_EQ(clock.StepOfFrame(frame), frame);
    }
    EXPECT_EQ(clock.SecondsOfFrame(30), 0.5);
}

TEST(FrameClock, FloorsToTheStepThatHasBeenReached)
{
    const FrameClock clock{Parsed("30"), Parsed("100"), Parsed("1")};
    EXPECT_EQ(clock.StepOfFrame(0), 0);
    EXPECT_EQ(clock.StepOfFrame(1), 3); // 3.33
    EXPECT_EQ(clock.StepOfFrame(2), 6); // 6.67
    EXPECT_EQ(clock.StepOfFrame(3), 10);
}

TEST(FrameClock, RepeatsStepsInSlowMotion)
{
    const FrameClock clock{Parsed("60"), Parsed("60"), Parsed("0.25")};
    EXPECT_EQ(clock.StepOfFrame(3), 0);
    EXPECT_EQ(clock.StepOfFrame(4), 1);
    EXPECT_EQ(clock.SecondsOfFrame(240), 1.0);
    EXPECT_EQ(clock.FilmSecondsOfFrame(240), 4.0);
}

// 29.97 = 2997/100, so 2997 frames take exactly 100 s, which is 6000 steps; a clock that adds up
// periods in floating point is off by whole steps long before the end.
TEST(FrameClock, ReturnsFractionOfTheNextStep)
{
    const FrameClock slow{Parsed("60"), Parsed("60"), Parsed("0.25")};
    EXPECT_EQ(slow.FractionOfFrame(0), 0.0);
    EXPECT_EQ(slow.FractionOfFrame(1), 0.25);
    EXPECT_EQ(slow.FractionOfFrame(3), 0.75);
    EXPECT_EQ(slow.FractionOfFrame(4), 0.0);
    const FrameClock odd{Parsed("50"), Parsed("60"), Parsed("1")};
    EXPECT_DOUBLE_EQ(odd.FractionOfFrame(1), 0.2);
    EXPECT_EQ(odd.FractionOfFrame(5), 0.0);
    const FrameClock film{Parsed("29.97"), Parsed("60"), Parsed("1")};
    EXPECT_EQ(film.FractionOfFrame(99'900'000'000), 0.0); // no drift: a whole number of steps
    EXPECT_GT(film.FractionOfFrame(99'900'000'001), 0.0);
    const FrameClock extreme{Rational{999'999'999, 1}, Rational{999'999'998, 999'999'999},
                             Rational{1, 999'999'997}};
    EXPECT_LT(extreme.FractionOfFrame(100'000'000'000), 1.0);
}

TEST(FrameClock, DoesNotDriftOverAHundredMillionFramesAt2997)
{
    const FrameClock clock{Parsed("29.97"), Parsed("60"), Parsed("1")};
    constexpr std::int64_t kFar = 100'000'000;
    for (std::int64_t frame = kFar; frame < kFar + 300; ++frame)
    {
        const std::int64_t periods = frame / 2997;
        const std::int64_t rest = frame % 2997;
        EXPECT_EQ(clock.StepOfFrame(frame), periods * 6000 + rest * 6000 / 2997) << frame;
        EXPECT_EQ(clock.SecondsOfFrame(frame), double(periods * 100) + double(rest * 100) / 2997.0)
            << frame;
    }
}

TEST(FrameClock, AdvancesByAtMostOneStepInSlowMotion)
{
    const FrameClock clock{Parsed("30000/1001"), Parsed("240"), Parsed("0.1")};
    std::int64_t last = 0;
    for (std::int64_t frame = 1; frame < 100'000; ++frame)
    {
        const std::int64_t step = clock.StepOfFrame(frame);
        ASSERT_TRUE(step == last || step == last + 1) << frame;
        last = step;
    }
    EXPECT_EQ(last, 80'079); // 99999 * 0.1 * 240 * 1001 / 30000 = 80079.99
}

TEST(FrameClock, HoldsTheLargestPartsWithoutOverflow)
{
    const FrameClock clock{Rational{1, 1'000'000'000}, Rational{1'000'000'000, 999'999'999},
                           Rational{999'999'999, 1'000'000'000}};
    EXPECT_EQ(clock.StepOfFrame(1'000'000'000), 1'000'000'000'000'000'000);
    const FrameClock slow{Rational{1'000'000'000, 1}, Rational{1, 1'000'000'000},
                          Rational{1, 1'000'000'000}};
    EXPECT_EQ(slow.StepOfFrame(100'000'000'000), 0);
}

} // namespace
