// SPDX-License-Identifier: MIT
#include <golden/Compare.h>

#include "../base/Errors.h"
#include "TestPictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

using namespace boxreel;
using namespace boxreel::test;
using testing::HasSubstr;
using testing::Not;

namespace
{

// The debug drawing's outline colours, the colour-blind-safe theme's, and the corners of the cube.
const std::vector<Color>& Colors()
{
    static const std::vector<Color> colors{
        {230, 179, 179}, {128, 230, 128}, {128, 128, 230}, {153, 153, 153}, {128, 128, 77},
        {128, 204, 204}, {230, 77, 230},  {77, 230, 230},  {230, 159, 0},   {86, 180, 233},
        {0, 158, 115},   {240, 228, 66},  {0, 114, 178},   {213, 94, 0},    {204, 121, 167},
        {0, 0, 0},       {255, 0, 0},     {0, 255, 0},     {0, 0, 255},     {0, 255, 255},
        {255, 0, 255},   {255, 255, 0},   {255, 255, 255}, {6, 255, 255}};
    return colors;
}

Color FillOver(Color outline, Color ground)
{
    const auto mix = [](int over, int under) {
        return static_cast<std::uint8_t>(over / 4 + under / 2);
    };
    return {mix(outline.r, ground.r), mix(outline.g, ground.g), mix(outline.b, ground.b), 255};
}

// Off by four away from the nearer end of the range.
std::uint8_t OffByFour(std::uint8_t value)
{
    return static_cast<std::uint8_t>(value < 128 ? value + 4 : value - 4);
}

Color OffByFour(Color color, int channels)
{
    return {channels & 1 ? OffByFour(color.r) : color.r,
            channels & 2 ? OffByFour(color.g) : color.g,
            channels & 4 ? OffByFour(color.b) : color.b, color.a};
}

Frame ShiftedRight(const Frame& frame)
{
    Frame shifted = frame;
    for (int y = 0; y < frame.height; ++y)
    {
        std::memmove(shifted.Pixel(1, y), frame.Pixel(0, y), std::size_t(frame.width - 1) * 4);
    }
    return shifted;
}

// OKLab as its author writes it down, with the C library's functions.
double PlainDistance(Color p, Color q)
{
    const auto lab = [](Color c) {
        const auto linear = [](double v) {
            v /= 255.0;
            return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        };
        const double r = linear(c.r), g = linear(c.g), b = linear(c.b);
        const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
        const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
        const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
        return std::array<double, 3>{0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
                                     1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
                                     0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
    };
    const auto a = lab(p), b = lab(q);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double DistanceOf(Color p, Color q)
{
    return Compare(Filled(1, 1, p), Filled(1, 1, q)).largestDistance;
}

} // namespace

TEST(CompareDistance, IsOneFromBlackToWhite)
{
    EXPECT_NEAR(DistanceOf({0, 0, 0}, {255, 255, 255}), 1.0, 1e-6);
}

TEST(CompareDistance, EqualsDistanceInOkLab)
{
    std::mt19937 random(7);
    const auto byte = [&] { return static_cast<std::uint8_t>(random() & 255u); };
    for (int i = 0; i < 2000; ++i)
    {
        const Color p{byte(), byte(), byte()};
        const Color q{byte(), byte(), byte()};
        EXPECT_NEAR(DistanceOf(p, q), PlainDistance(p, q), 1e-9);
    }
}

// Bits, not values: any compiler and optimisation has to give these.
TEST(CompareDistance, HasTheSameBitsEverywhere)
{
    std::mt19937 random(11);
    const auto byte = [&] { return static_cast<std::uint8_t>(random() & 255u); };
    std::uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < 5000; ++i)
    {
        const Color p{byte(), byte(), byte()};
        const Color q{byte(), byte(), byte()};
        const double distance = DistanceOf(p, q);
        std::uint64_t bits;
        std::memcpy(&bits, &distance, sizeof bits);
        hash = (hash ^ bits) * 1099511628211u;
    }
    EXPECT_EQ(hash, 11746704345878083431u);
}

TEST(CompareDistance, IsNotZeroWhenOnlyOpacityChanges)
{
    const Color hidden{0, 0, 0, 0};
    const Color black{0, 0, 0, 255};
    EXPECT_NEAR(DistanceOf(hidden, black), 1.0, 1e-6) << "on white one is white, the other black";
    EXPECT_FALSE(
        Compare(Filled(40, 40, {60, 60, 60, 128}), Filled(40, 40, {60, 60, 60, 132})).equal);
}

TEST(CompareSameMachine, PassesAnEqualPicture)
{
    const Comparison result = Compare(Painted(SmallScene()), Painted(SmallScene()));
    EXPECT_TRUE(result.equal);
    EXPECT_EQ(result.differentPixels, 0);
    EXPECT_EQ(result.firstX, -1);
}

TEST(CompareSameMachine, FailsAPictureShiftedByOnePixel)
{
    for (const Color ground : {kDark, kLight})
    {
        const Frame picture = Painted(SmallScene(), {.ground = ground});
        EXPECT_FALSE(Compare(picture, ShiftedRight(picture)).equal);
    }
}

TEST(CompareSameMachine, FailsASingleDotThatMovedByOnePixel)
{
    Frame picture = Filled(64, 64, kDark);
    *picture.Pixel(30, 30) = 230;
    EXPECT_FALSE(Compare(picture, ShiftedRight(picture)).equal);
}

TEST(CompareSameMachine, FailsPatchOffByFourInAnyChannel)
{
    std::vector<Color> colors = Colors();
    for (const Color color : Colors())
    {
        for (const Color ground : {kDark, kLight, Color{0, 0, 0}, Color{255, 255, 255}})
        {
            colors.push_back(FillOver(color, ground));
        }
    }
    colors.insert(colors.end(), {kDark, kLight});
    for (const Color color : colors)
    {
        for (const int channels : {1, 2, 4, 7})
        {
            const Frame expected = Filled(64, 64, color);
            Frame actual = expected;
            FillRect(actual, 10, 12, 50, 52, OffByFour(color, channels));
            const Comparison result = Compare(expected, actual);
            EXPECT_FALSE(result.equal) << int(color.r) << "," << int(color.g) << "," << int(color.b)
                                       << " channels " << channels << ": " << result.Text();
            EXPECT_EQ(result.overTolerance, 1600);
            EXPECT_EQ(result.worstWindow, 256);
            EXPECT_EQ(result.firstX, 10);
            EXPECT_EQ(result.firstY, 12);
        }
    }
}

TEST(CompareSameMachine, HasToleranceBelowAnyChannelOffByFour)
{
    const double tolerance = CompareSettings::SameMachine().tolerance;
    const auto level = [](int i) { return static_cast<std::uint8_t>(std::min(i * 9, 251)); };
    for (int i = 0; i < 29 * 29 * 29; ++i)
    {
        const Color p{level(i % 29), level(i / 29 % 29), level(i / 841)};
        for (const Color q :
             {Color{std::uint8_t(p.r + 4), p.g, p.b}, Color{p.r, std::uint8_t(p.g + 4), p.b},
              Color{p.r, p.g, std::uint8_t(p.b + 4)}})
        {
            ASSERT_GT(DistanceOf(p, q), tolerance)
                << int(p.r) << "," << int(p.g) << "," << int(p.b);
        }
    }
}

TEST(CompareSameMachine, PassesASingleStrayPixelOfAnyColour)
{
    const Frame expected = Painted(SmallScene());
    for (const Color color : Colors())
    {
        for (const auto& [x, y] : {std::pair{0, 0}, {319, 179}, {160, 60}})
        {
            Frame actual = expected;
            FillRect(actual, x, y, x + 1, y + 1, color);
            EXPECT_TRUE(Compare(expected, actual).equal);
        }
    }
}

TEST(CompareSameMachine, PassesFourScatteredPixelsButNotFive)
{
    const Frame expected = Filled(200, 100, kDark);
    Frame actual = expected;
    for (const int x : {10, 60, 110, 160})
    {
        FillRect(actual, x, 50, x + 1, 51, kAwake);
    }
    EXPECT_TRUE(Compare(expected, actual).equal);
    FillRect(actual, 199, 99, 200, 100, kAwake);
    EXPECT_FALSE(Compare(expected, actual).equal);
}

TEST(CompareSameMachine, FailsTwoPixelsInOneWindowWhereverItLies)
{
    const Frame expected = Filled(64, 64, kDark);
    for (int x = 0; x < 48; ++x)
    {
        Frame actual = expected;
        FillRect(actual, x, 20, x + 1, 21, kAwake);
        FillRect(actual, x + 15, 35, x + 16, 36, kAwake);
        const Comparison near = Compare(expected, actual);
        EXPECT_EQ(near.worstWindow, 2) << "x " << x << ", windows need not be aligned";
        EXPECT_FALSE(near.equal);

        actual = expected;
        FillRect(actual, x, 20, x + 1, 21, kAwake);
        FillRect(actual, x + 16, 20, x + 17, 21, kAwake);
        EXPECT_EQ(Compare(expected, actual).worstWindow, 1) << "x " << x << ", one pixel too far";
    }
}

TEST(CompareCrossMachine, PassesFillsOffByTwoAndFailsOffByFour)
{
    const auto shifted = [](Color color, int by) {
        const auto one = [by](std::uint8_t value) {
            return static_cast<std::uint8_t>(value < 128 ? value + by : value - by);
        };
        return Color{one(color.r), one(color.g), one(color.b)};
    };
    for (const Color outline : Colors())
    {
        for (const Color ground : {kDark, kLight})
        {
            for (const Color color : {FillOver(outline, ground), ground})
            {
                const Frame expected = Filled(64, 64, color);
                const Comparison byTwo = Compare(expected, Filled(64, 64, shifted(color, 2)),
                                                 CompareSettings::CrossMachine());
                EXPECT_EQ(byTwo.overTolerance, 0) << int(color.r) << "," << int(color.g) << ","
                                                  << int(color.b) << ": " << byTwo.Text();
                const Color other{std::uint8_t(color.r < 250 ? color.r + 4 : color.r - 4),
                                  std::uint8_t(color.g < 250 ? color.g + 4 : color.g - 4),
                                  std::uint8_t(color.b < 250 ? color.b + 4 : color.b - 4)};
                EXPECT_FALSE(
                    Compare(expected, Filled(64, 64, other), CompareSettings::CrossMachine()).equal)
                    << int(color.r) << "," << int(color.g) << "," << int(color.b);
            }
        }
    }
}

// Differences as a renderer with other rounding leaves them: anywhere, in any colour.
TEST(CompareCrossMachine, PassesScatteredAndFailsClusteredPixels)
{
    const Frame expected = Filled(640, 360, kDark);
    std::mt19937 random(5);
    Frame scattered = expected, together = expected;
    for (int i = 0; i < 100; ++i)
    {
        const int x = static_cast<int>(random() % 640), y = static_cast<int>(random() % 360);
        FillRect(scattered, x, y, x + 1, y + 1, kAwake);
        FillRect(together, 300 + i % 10, 100 + i / 10, 301 + i % 10, 101 + i / 10, kAwake);
    }
    const Comparison passed = Compare(expected, scattered, CompareSettings::CrossMachine());
    EXPECT_TRUE(passed.equal) << passed.Text();
    EXPECT_GT(passed.overTolerance, 90);
    const Comparison failed = Compare(expected, together, CompareSettings::CrossMachine());
    EXPECT_FALSE(failed.equal) << failed.Text();
    EXPECT_EQ(failed.overTolerance, 100);
}

TEST(CompareRatio, IsCheckedInAdditionToTheCount)
{
    const Frame expected = Filled(100, 100, kDark);
    Frame actual = expected;
    FillRect(actual, 0, 0, 10, 1, kAwake);
    CompareSettings settings;
    settings.maxInWindow = 100;
    settings.maxPixels = 10;
    settings.maxRatio = 0.001; // of 10000
    EXPECT_TRUE(Compare(expected, actual, settings).equal);
    settings.maxRatio = 0.0009;
    EXPECT_FALSE(Compare(expected, actual, settings).equal);
    settings.maxRatio = 1.0;
    settings.maxPixels = 9;
    EXPECT_FALSE(Compare(expected, actual, settings).equal);
    settings.maxPixels = kAnyNumberOfPixels;
    EXPECT_TRUE(Compare(expected, actual, settings).equal);
}

TEST(CompareIgnored, ExcludesPixelsInRectangles)
{
    const Frame expected = Filled(64, 64, kDark);
    Frame actual = expected;
    FillRect(actual, 10, 10, 20, 20, kAwake);
    CompareSettings settings = CompareSettings::Exact();
    settings.ignored = {{10, 10, 20, 15}, {10, 14, 20, 20}};
    const Comparison result = Compare(expected, actual, settings);
    EXPECT_TRUE(result.equal) << result.Text();
    EXPECT_EQ(result.differentPixels, 0);
    EXPECT_EQ(result.largestDistance, 0.0);
    EXPECT_EQ(result.ignored, 100);
    EXPECT_EQ(result.compared, 64 * 64 - 100) << "where they overlap, pixels count once";
    for (const PixelBounds& bounds : {PixelBounds{11, 10, 20, 20}, PixelBounds{10, 11, 20, 20},
                                      PixelBounds{10, 10, 19, 20}, PixelBounds{10, 10, 20, 19}})
    {
        settings.ignored = {bounds};
        EXPECT_EQ(Compare(expected, actual, settings).overTolerance, 10);
    }
}

TEST(CompareIgnored, AcceptsRectanglesBeyondThePicture)
{
    const Frame expected = Filled(64, 64, kDark);
    Frame actual = expected;
    FillRect(actual, 60, 60, 64, 64, kAwake);
    CompareSettings settings;
    settings.ignored = {{60, 60, 500, 500}};
    EXPECT_TRUE(Compare(expected, actual, settings).equal);
    settings.ignored = {{500, 500, 600, 600}, {-9, -9, 0, 0}};
    EXPECT_FALSE(Compare(expected, actual, settings).equal);
    EXPECT_EQ(Compare(expected, actual, settings).compared, 64 * 64);
}

TEST(CompareIgnored, FailsWhenAllPixelsAreIgnored)
{
    const Frame expected = Filled(64, 64, kDark);
    CompareSettings settings;
    settings.ignored = {{0, 0, 64, 63}};
    EXPECT_TRUE(Compare(expected, expected, settings).equal);
    settings.ignored.push_back({0, 60, 99, 99});
    const Comparison result = Compare(expected, expected, settings);
    EXPECT_FALSE(result.equal);
    EXPECT_EQ(result.compared, 0);
    EXPECT_EQ(result.ignored, 4096);
}

TEST(CompareIgnored, ExcludesPixelsFromTheRatio)
{
    const Frame expected = Filled(100, 100, kDark);
    Frame actual = expected;
    FillRect(actual, 0, 0, 10, 1, kAwake);
    CompareSettings settings;
    settings.maxPixels = settings.maxInWindow = 100;
    settings.maxRatio = 0.001;
    settings.ignored = {{0, 99, 1, 100}};
    EXPECT_FALSE(Compare(expected, actual, settings).equal) << "10 of 9999";
}

TEST(CompareWindows, CountAsASimpleLoopDoes)
{
    std::mt19937 random(3);
    for (int round = 0; round < 20; ++round)
    {
        const int width = 1 + static_cast<int>(random() % 40),
                  height = 1 + static_cast<int>(random() % 40);
        const int size = 1 + static_cast<int>(random() % 20);
        const Frame expected = Filled(width, height, kDark);
        Frame actual = expected;
        for (int i = 0; i < 30; ++i)
        {
            const int x = static_cast<int>(random() % unsigned(width)),
                      y = static_cast<int>(random() % unsigned(height));
            FillRect(actual, x, y, x + 1, y + 1, kAwake);
        }
        int worst = 0;
        for (int y0 = 0; y0 < height; ++y0)
        {
            for (int x0 = 0; x0 < width; ++x0)
            {
                int count = 0;
                for (int y = y0; y < std::min(y0 + size, height); ++y)
                {
                    for (int x = x0; x < std::min(x0 + size, width); ++x)
                    {
                        count += *actual.Pixel(x, y) != *expected.Pixel(x, y);
                    }
                }
                worst = std::max(worst, count);
            }
        }
        EXPECT_EQ(Compare(expected, actual, {.densityWindow = size}).worstWindow, worst);
    }
}

TEST(CompareExact, FailsASingleBit)
{
    const Frame expected = Filled(64, 64, kDark);
    for (const std::size_t byte : {std::size_t(0), std::size_t(3), expected.rgba.size() - 1})
    {
        Frame actual = expected;
        actual.rgba[byte] = static_cast<std::uint8_t>(actual.rgba[byte] ^ 1);
        EXPECT_FALSE(Compare(expected, actual, CompareSettings::Exact()).equal);
        EXPECT_TRUE(Compare(expected, actual).equal) << "a single stray pixel";
    }
    EXPECT_TRUE(Compare(expected, expected, CompareSettings::Exact()).equal);
}

TEST(CompareExact, FailsAnInvisibleBit)
{
    // More light than its opacity allows: white on any background, with either last bit of
    // opacity.
    const Frame expected = Filled(8, 8, {255, 255, 255, 255});
    const Frame actual = Filled(8, 8, {255, 255, 255, 254});
    EXPECT_EQ(Compare(expected, actual).largestDistance, 0.0);
    EXPECT_FALSE(Compare(expected, actual, CompareSettings::Exact()).equal);
}

TEST(Compare, FailsOtherSizes)
{
    const Frame picture = Filled(40, 30, kDark);
    for (const Frame& other :
         {Filled(41, 30, kDark), Filled(40, 29, kDark), Filled(30, 40, kDark), Frame()})
    {
        const Comparison result = Compare(picture, other);
        EXPECT_FALSE(result.equal);
        EXPECT_FALSE(result.sameSize);
        EXPECT_EQ(result.expectedSize, (std::array{40, 30}));
        EXPECT_EQ(result.actualSize, (std::array{other.width, other.height}));
        EXPECT_EQ(Compare(other, picture).sameSize, false);
    }
}

TEST(Compare, FailsOtherSizesEvenWhenEveryLimitAllowsIt)
{
    CompareSettings loose;
    loose.maxPixels = loose.maxInWindow = 1000000;
    EXPECT_FALSE(Compare(Filled(40, 30, kDark), Filled(40, 31, kDark), loose).equal);
}

TEST(Compare, PassesTwoEmptyPictures)
{
    EXPECT_TRUE(Compare(Frame(), Frame()).equal);
}

TEST(Compare, CountsPixelsWithinToleranceSeparately)
{
    const Frame expected = Filled(64, 64, kDark);
    Frame actual = expected;
    FillRect(actual, 0, 0, 10, 1, {27, 27, 27});
    FillRect(actual, 40, 40, 41, 41, {255, 255, 255});
    CompareSettings settings;
    settings.tolerance = 0.01;
    const Comparison result = Compare(expected, actual, settings);
    EXPECT_EQ(result.differentPixels, 11);
    EXPECT_EQ(result.overTolerance, 1);
    EXPECT_EQ(result.firstX, 40);
    EXPECT_EQ(result.firstY, 40);
    EXPECT_TRUE(result.equal);
}

TEST(CompareVerdict, NamesTheLimitsAndTheirOrigin)
{
    const Frame expected = Filled(64, 64, kDark);
    Frame actual = expected;
    FillRect(actual, 7, 5, 9, 6, kAwake);
    const std::string text = Compare(expected, actual).Text();
    for (const char* part : {"different", "2 pixels", "7,5", "0.598", "same-machine", "0.00025"})
    {
        EXPECT_THAT(text, HasSubstr(part));
    }
    CompareSettings own = CompareSettings::Exact();
    own.options = {"--max-pixels", "--ignore"};
    own.maxPixels = 7;
    for (const char* part : {"exact", "--max-pixels", "--ignore", "7 pixels"})
    {
        EXPECT_THAT(DescribeLimits(own), HasSubstr(part));
    }
}

TEST(CompareVerdict, NamesChangedSettingsOfPreset)
{
    CompareSettings own = CompareSettings::Exact();
    own.tolerance = 0.1;
    own.maxPixels = 1000;
    for (const char* part : {"exact", "tolerance", "maxPixels", "1000 pixels", "0.1"})
    {
        EXPECT_THAT(DescribeLimits(own), HasSubstr(part));
    }
    EXPECT_THAT(DescribeLimits(CompareSettings()), Not(HasSubstr("another")));
    own = CompareSettings::CrossMachine();
    own.edgeShift = 0.4;
    own.maxRatio = 0.5;
    own.densityWindow = 8;
    own.maxInWindow = 9;
    for (const char* part : {"cross-machine", "edgeShift", "maxRatio", "maxInWindow", "window",
                             "50 %", "0.4 px", "9 in any 8x8"})
    {
        EXPECT_THAT(DescribeLimits(own), HasSubstr(part));
    }
    EXPECT_THAT(DescribeLimits(own), Not(HasSubstr("tolerance")));
}

TEST(CompareVerdict, RoundsNoLimit)
{
    CompareSettings own;
    for (const auto& [ratio, text] : {std::pair(0.9999, ", 99.99 % over"),
                                      {0.0000012345678, ", 0.00012345678 % over"},
                                      {0.07, ", 7 % over"},
                                      {0.001, ", 0.1 % over"}})
    {
        own.maxRatio = ratio;
        EXPECT_THAT(DescribeLimits(own), HasSubstr(text));
    }
}

TEST(CompareVerdict, NamesRatioAndEdgesAcrossMachines)
{
    const Frame expected = Filled(64, 64, kDark);
    EXPECT_EQ(Compare(expected, expected, CompareSettings::CrossMachine()).Text(),
              "equal: no pixel differs (cross-machine allows 0.05 % over a distance of 0.01 and "
              "edges 0.2 px elsewhere, 8 in any 16x16)");
}

TEST(Compare, PaintsNoDifferenceWhenNoneIsWanted)
{
    CompareSettings settings;
    settings.paintsDifference = false;
    const Comparison result = Compare(Filled(8, 8, kDark), Filled(8, 8, kLight), settings);
    EXPECT_FALSE(result.equal);
    EXPECT_EQ(result.difference, Frame());
}

TEST(ComparePreset, IsFoundByName)
{
    const Result<CompareSettings> exact = CompareSettings::Preset("--preset", "exact");
    ASSERT_TRUE(exact);
    EXPECT_EQ(exact->tolerance, 0.0);
    EXPECT_EQ(exact->maxPixels, 0);
    const Result<CompareSettings> sameMachine = CompareSettings::Preset("--preset", "same-machine");
    ASSERT_TRUE(sameMachine);
    EXPECT_EQ(sameMachine->tolerance, CompareSettings().tolerance);
}

TEST(ComparePreset, IsRefusedWithAListWhenUnknown)
{
    EXPECT_THAT(CompareSettings::Preset("--preset", "fuzzy"),
                RefusesWith("--preset fuzzy", "exact, same-machine, cross-machine"));
}
