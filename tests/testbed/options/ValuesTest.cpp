// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"

#include <base/Quoting.h>
#include <options/Values.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

std::int64_t Nanoseconds(std::string_view text)
{
    const Result<Duration> duration = ParseDuration("--at", text);
    return duration ? duration->nanoseconds : -1;
}

TEST(Values, ReadsTimesExactly)
{
    EXPECT_EQ(Nanoseconds("3s"), 3'000'000'000);
    EXPECT_EQ(Nanoseconds("3"), 3'000'000'000);
    EXPECT_EQ(Nanoseconds("2.5"), 2'500'000'000);
    EXPECT_EQ(Nanoseconds("0.1s"), 100'000'000);
    EXPECT_EQ(Nanoseconds("500ms"), 500'000'000);
    EXPECT_EQ(Nanoseconds("0.5ms"), 500'000);
    EXPECT_EQ(Nanoseconds("0"), 0);
    EXPECT_EQ(Nanoseconds("0.000000001"), 1);
    EXPECT_EQ(Nanoseconds("1000000"), 1'000'000'000'000'000);
}

TEST(Values, RefusesInvalidTimes)
{
    for (const char* text : {"",
                             "s",
                             "ms",
                             "-1",
                             "+1",
                             "nan",
                             "inf",
                             "1e3",
                             "3 s",
                             " 3",
                             "3x",
                             "3ss",
                             ".",
                             "1.",
                             ".5",
                             "1.2.3",
                             "1,5",
                             "0x3",
                             "1000001",
                             "1000000.5",
                             "99999999999999999999",
                             "999999999999999999999ms"})
    {
        EXPECT_EQ(Nanoseconds(text), -1) << text;
    }
}

TEST(Values, RoundsTimesFinerThanANanosecond)
{
    EXPECT_EQ(Nanoseconds("0.46666666666666667"), 466'666'667);
    EXPECT_EQ(Nanoseconds("0.0000000001"), 0);
    EXPECT_EQ(Nanoseconds("0.0000000005"), 1);
    EXPECT_EQ(Nanoseconds("0.99999999999999999999999ms"), 1'000'000);
    EXPECT_EQ(Nanoseconds("0.12345678x9"), -1);
}

TEST(Values, NamesOptionAndTextInRefusal)
{
    const Result<Duration> duration = ParseDuration("--seconds", "nan");
    ASSERT_FALSE(duration);
    EXPECT_EQ(duration.GetError().kind, ErrorKind::Unusable);
    EXPECT_EQ(duration.GetError().culprit, "--seconds nan");
}

TEST(Values, RefusesWholeNumbersOutOfRange)
{
    const auto read = [](std::string_view text) {
        const Result<std::int64_t> value = ParseWhole("--frames", text, 1, 1000);
        return value ? *value : -1;
    };
    EXPECT_EQ(read("1"), 1);
    EXPECT_EQ(read("1000"), 1000);
    for (const char* text :
         {"", "0", "1001", "-5", "+5", "5.0", "5f", " 5", "1000000000000", "99999999999999999999"})
    {
        EXPECT_EQ(read(text), -1) << text;
    }
}

TEST(Values, ReadsSizesAsTwoNumbersOfPixels)
{
    const Result<PixelSize> size = ParseSize("--size", "1920x1080");
    ASSERT_TRUE(size);
    EXPECT_EQ(*size, (PixelSize{1920, 1080}));
    EXPECT_TRUE(ParseSize("--size", "1x1"));
    EXPECT_TRUE(ParseSize("--size", "8192x8192"));
    for (const char* text :
         {"", "x", "640", "640x", "x480", "0x720", "1280x0", "8193x10", "-640x480", "640x480x3",
          "640 x 480", "640X480", "6.4x4", "99999999999x1", "640*480"})
    {
        EXPECT_THAT(ParseSize("--size", text), Refuses(AsTyped("--size", text)));
    }
}

TEST(Values, ReadsRatesAsFractionsWithinRange)
{
    const Result<Rational> rate = ParseRatio("--fps", "30000/1001", 0.1, 1000.0);
    ASSERT_TRUE(rate);
    EXPECT_EQ(*rate, (Rational{30000, 1001}));
    for (const char* text : {"0", "-60", "nan", "1001", "60fps", ""})
    {
        EXPECT_FALSE(ParseRatio("--fps", text, 0.1, 1000.0)) << text;
    }
    const auto refusal = [](const char* text) {
        return ParseRatio("--fps", text, 0.1, 1000.0).GetError().culprit;
    };
    EXPECT_EQ(refusal("1001"), "--fps 1001");
    EXPECT_EQ(ParseRatio("--hz", "0.5", 1.0, 1000.0).GetError().culprit, "--hz 0.5");
    EXPECT_EQ(refusal("29.97002997"), "--fps 29.97002997");
}

TEST(Values, RefusesNumbersThatAreNotFinite)
{
    const Result<double> number = ParseNumber("--camera", "-2.5");
    ASSERT_TRUE(number);
    EXPECT_EQ(*number, -2.5);
    for (const char* text : {"", "nan", "inf", "-inf", "1e999", "2,5", "2.5m"})
    {
        EXPECT_FALSE(ParseNumber("--camera", text)) << text;
    }
}

TEST(Values, RoundsLengthToNearestFrame)
{
    EXPECT_EQ(FramesIn(Duration{10'000'000'000}, Rational{60, 1}), 600);
    EXPECT_EQ(FramesIn(Duration{10'000'000'000}, Rational{30000, 1001}), 300);
    EXPECT_EQ(FramesIn(Duration{1}, Rational{60, 1}), 1) << "a film has at least one frame";
    EXPECT_EQ(FramesIn(Duration{1'000'000'000'000'000}, Rational{999999999, 1000000}), 999999999);
}

TEST(Values, RoundsTimeDownToStep)
{
    EXPECT_EQ(StepAt(Duration{3'000'000'000}, Rational{60, 1}), 180);
    EXPECT_EQ(StepAt(Duration{100'000'000}, Rational{60, 1}), 6);
    EXPECT_EQ(StepAt(Duration{99'999'999}, Rational{60, 1}), 5);
    EXPECT_EQ(StepAt(Duration{0}, Rational{60, 1}), 0);
    EXPECT_EQ(StepAt(Duration{1'000'000'000'000'000}, Rational{100000, 1}), 100'000'000'000);
}

} // namespace
} // namespace boxreel
