// SPDX-License-Identifier: MIT
// Compares the approximation of four pixels at a time with the plain functions that define it.
#include "PixelMarks.h"
#include "EdgeRule.h"
#include "OkLab.h"
#include "TestPictures.h"

#include <golden/Compare.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

using namespace boxreel;
using namespace boxreel::test;

namespace
{

Words Repeated(std::uint32_t pixel)
{
    return Words{pixel, pixel, pixel, pixel};
}

std::uint32_t WordOf(const std::uint8_t* bytes)
{
    std::uint32_t word;
    std::memcpy(&word, bytes, 4);
    return word;
}

// Each pixel for itself: PixelDistance, then EdgeExplains.
struct Plain
{
    Comparison result;
    std::vector<Mark> marks;

    Plain(const Frame& expected, const Frame& actual, const CompareSettings& settings)
        : marks(std::size_t(expected.width) * std::size_t(expected.height), Mark::Same)
    {
        for (int y = 0; y < expected.height; ++y)
        {
            for (int x = 0; x < expected.width; ++x)
            {
                const std::uint8_t *p = expected.Pixel(x, y), *q = actual.Pixel(x, y);
                if (std::memcmp(p, q, 4) == 0)
                {
                    continue;
                }
                const double distance = PixelDistance(p, q);
                bool isOver = distance > settings.tolerance || settings.tolerance <= 0.0;
                if (isOver && settings.edgeShift > 0.0 &&
                    EdgeExplains(expected, x, y, q, settings.tolerance, settings.edgeShift))
                {
                    isOver = false;
                    ++result.excusedAtEdges;
                }
                marks[std::size_t(y * expected.width + x)] = isOver ? Mark::Over : Mark::Within;
                ++result.differentPixels;
                result.overTolerance += isOver;
                result.largestDistance = std::max(result.largestDistance, distance);
            }
        }
    }
};

void ExpectAsPlain(const Frame& expected, const Frame& actual, const CompareSettings& settings)
{
    const Plain plain(expected, actual, settings);
    Comparison result;
    const Marks marks = MarkDifferences(expected, actual, settings, result);
    EXPECT_EQ(marks.marks.empty() ? std::vector<Mark>(plain.marks.size()) : marks.marks,
              plain.marks);
    EXPECT_EQ(result.differentPixels, plain.result.differentPixels);
    EXPECT_EQ(result.overTolerance, plain.result.overTolerance);
    EXPECT_EQ(result.excusedAtEdges, plain.result.excusedAtEdges);
    EXPECT_EQ(result.largestDistance, plain.result.largestDistance) << "every bit of it";
}

// Blocks of a few colours, some translucent, with specks.
Frame Blocks(std::mt19937& random, int width, int height)
{
    std::uint8_t colors[6][4];
    for (auto& color : colors)
    {
        for (int i = 0; i < 4; ++i)
        {
            color[i] = std::uint8_t(i == 3 && random() % 3 > 0 ? 255 : random());
        }
    }
    Frame frame(width, height);
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            const auto index =
                std::uint32_t(random() % 6 == 0 ? random() : std::uint64_t(x / 7 + y / 5));
            std::memcpy(frame.Pixel(x, y), colors[index % 6], 4);
        }
    }
    return frame;
}

// Returns the frame with edges shifted by `share` of a pixel, and with noise on some pixels.
Frame Altered(std::mt19937& random, const Frame& frame, double share, int noise)
{
    Frame altered = frame;
    for (int y = 0; y < frame.height; ++y)
    {
        for (int x = 0; x < frame.width; ++x)
        {
            const int noisy = random() % 4 == 0 ? noise : 0;
            for (int i = 0; i < 4; ++i)
            {
                const double here = frame.Pixel(x, y)[i];
                const double left = frame.Pixel(std::max(x - 1, 0), y)[i];
                const int off = int(random() % std::uint32_t(2 * noisy + 1)) - noisy;
                altered.Pixel(x, y)[i] = std::uint8_t(
                    std::clamp(int(std::lround(here + (left - here) * share)) + off, 0, 255));
            }
        }
    }
    return altered;
}

} // namespace

// 2^24 colours. The distance of two pixels is off by at most the sum of what each is off.
TEST(NearlyPixelDistance, StaysWithinErrorBoundForEveryColour)
{
    const std::uint8_t black[4] = {0, 0, 0, 255};
    float worst = 0.0f;
    for (std::uint32_t color = 0; color < 1u << 24; color += kLanes)
    {
        std::uint8_t bytes[kLanes][4];
        for (std::uint32_t i = 0; i < kLanes; ++i)
        {
            const std::uint8_t one[4] = {std::uint8_t(color + i), std::uint8_t(color >> 8),
                                         std::uint8_t(color >> 16), 255};
            std::memcpy(bytes[i], one, 4);
        }
        Words words;
        std::memcpy(&words, bytes, sizeof words);
        const Floats nearly = NearlyPixelDistance(words, Repeated(WordOf(black)));
        for (int i = 0; i < kLanes; ++i)
        {
            worst = std::max(worst, std::abs(nearly[i] - float(PixelDistance(bytes[i], black))));
        }
    }
    EXPECT_LT(worst, kNearly / 2) << worst;
    EXPECT_GT(worst, 1e-6f) << "it is an approximation, or nothing was tried";
}

TEST(NearlyPixelDistance, StaysWithinErrorBoundForAnyPair)
{
    std::mt19937 random(3);
    for (int i = 0; i < 300000; ++i)
    {
        Words p{}, q{};
        for (int lane = 0; lane < kLanes; ++lane)
        {
            const std::uint32_t opaque = WordOf(std::vector<std::uint8_t>{0, 0, 0, 255}.data());
            p[lane] = std::uint32_t(random()) | (i % 2 == 0 ? opaque : 0u);
            // Near it, or anywhere.
            q[lane] = (i % 3 == 0 ? std::uint32_t(random())
                                  : p[lane] ^ (std::uint32_t(random()) & 0x07070707u)) |
                      (i % 2 == 0 ? opaque : 0u);
        }
        const Floats nearly = NearlyPixelDistance(p, q);
        for (int lane = 0; lane < kLanes; ++lane)
        {
            std::uint8_t a[4], b[4];
            const std::uint32_t wordA = p[lane], wordB = q[lane];
            std::memcpy(a, &wordA, 4);
            std::memcpy(b, &wordB, 4);
            ASSERT_NEAR(nearly[lane], PixelDistance(a, b), double(kNearly));
        }
    }
}

TEST(PixelMarks, EqualPlainFunctionsForRandomPictures)
{
    std::mt19937 random(1);
    for (int i = 0; i < 400; ++i)
    {
        SCOPED_TRACE(i);
        const int width = 1 + int(random() % 60), height = 1 + int(random() % 40);
        const Frame expected = Blocks(random, width, height);
        const Frame actual =
            random() % 3 == 0
                ? Blocks(random, width, height)
                : Altered(random, expected, double(random() % 50) / 50.0, int(random() % 12));
        CompareSettings settings = CompareSettings::CrossMachine();
        const double tolerances[] = {0.0, 0.00025, 0.003, 0.01, 0.05, 0.3};
        settings.tolerance = tolerances[random() % 6];
        settings.edgeShift = double(random() % 46) / 100.0;
        ExpectAsPlain(expected, actual, settings);
        if (HasFailure())
        {
            return;
        }
    }
}

TEST(PixelMarks, EqualPlainFunctionsForEdgesThatMove)
{
    std::mt19937 random(2);
    const Frame expected = Painted(SmallScene());
    for (const double share : {0.05, 0.1, 0.2, 0.3, 0.5, 1.0})
    {
        for (const int noise : {0, 1, 3})
        {
            SCOPED_TRACE(testing::Message() << share << " px, noise of " << noise);
            const Frame actual = Altered(random, expected, share, noise);
            ExpectAsPlain(expected, actual, CompareSettings::SameMachine());
            ExpectAsPlain(expected, actual, CompareSettings::CrossMachine());
            ExpectAsPlain(actual, expected, CompareSettings::CrossMachine());
        }
    }
}

// More pairs than the table has entries: the one that was there is judged again, and rightly.
TEST(PixelMarks, EqualPlainFunctionsWithoutRepeatedPairs)
{
    Frame expected(512, 300), actual(512, 300);
    std::mt19937 random(4);
    for (std::size_t i = 0; i < expected.rgba.size(); ++i)
    {
        expected.rgba[i] = std::uint8_t(i % 4 == 3 ? 255 : random());
        actual.rgba[i] = std::uint8_t(i % 4 == 3 ? 255 : random());
    }
    ExpectAsPlain(expected, actual, CompareSettings::CrossMachine());
    ExpectAsPlain(expected, actual, CompareSettings::SameMachine());
}

// A pair at the tolerance is within it, and over the next smaller number: no approximation may say
// otherwise.
TEST(PixelMarks, AreExactForPairsAtTheLimit)
{
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i)
    {
        const Frame expected = Blocks(random, 30, 20);
        const Frame actual = Altered(random, expected, 0.0, 4);
        CompareSettings settings;
        for (int x = 0; x < 30; ++x)
        {
            settings.tolerance = PixelDistance(expected.Pixel(x, 7), actual.Pixel(x, 7));
            ExpectAsPlain(expected, actual, settings);
            settings.tolerance = std::nextafter(settings.tolerance, 0.0);
            ExpectAsPlain(expected, actual, settings);
        }
    }
}
