// SPDX-License-Identifier: MIT
#include "YuvConvert.h"
#include "TestFilm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

/// Every conversion is compared with the exact value, computed here by the definition.
namespace
{

using boxreel::ConvertPixels;
using boxreel::Frame;
using boxreel::Instructions;
using boxreel::PicturePlanes;
using boxreel::PixelBounds;
using boxreel::PlaneFormat;
using boxreel::YuvMatrix;
using testfilm::FillRect;
using testfilm::Noise;
using testing::Each;
using testing::ElementsAre;

constexpr PlaneFormat kFormats[] = {PlaneFormat::Yuv420, PlaneFormat::Yuv444, PlaneFormat::Gbr,
                                    PlaneFormat::Bgr0, PlaneFormat::Rgb24};
constexpr std::uint8_t kUntouched = 0xa5;

/// Planes with bytes around each row that nothing may write.
class Picture
{
public:
    Picture(PlaneFormat format, int width, int height)
    {
        m_planes.format = format;
        const bool isHalved = format == PlaneFormat::Yuv420;
        const bool isPacked = format == PlaneFormat::Bgr0 || format == PlaneFormat::Rgb24;
        for (int i = 0; i < (isPacked ? 1 : 3); ++i)
        {
            const bool isSmall = isHalved && i > 0;
            m_widths[i] = format == PlaneFormat::Bgr0    ? width * 4
                          : format == PlaneFormat::Rgb24 ? width * 3
                                                         : Half(width, isSmall);
            m_heights[i] = Half(height, isSmall);
            const int stride = m_widths[i] + 2 * kMargin;
            m_bytes[i].assign(std::size_t(stride) * std::size_t(m_heights[i] + 2), kUntouched);
            m_planes.strides[i] = stride;
            m_planes.data[i] = m_bytes[i].data() + stride + kMargin;
        }
    }

    const PicturePlanes& Planes() const { return m_planes; }
    int Width(int plane) const { return m_widths[plane]; }
    int Height(int plane) const { return m_heights[plane]; }

    int At(int plane, int x, int y) const
    {
        return m_planes.data[plane][y * m_planes.strides[plane] + x];
    }

    /// Of what lies around the planes.
    std::vector<std::uint8_t> Surroundings() const
    {
        std::vector<std::uint8_t> bytes;
        for (int i = 0; i < 3; ++i)
        {
            for (std::ptrdiff_t k = 0; k < std::ptrdiff_t(m_bytes[i].size()); ++k)
            {
                const std::ptrdiff_t x = k % m_planes.strides[i] - kMargin;
                const std::ptrdiff_t y = k / m_planes.strides[i] - 1;
                if (x < 0 || x >= m_widths[i] || y < 0 || y >= m_heights[i])
                {
                    bytes.push_back(m_bytes[i][std::size_t(k)]);
                }
            }
        }
        return bytes;
    }

    bool operator==(const Picture& other) const { return m_bytes == other.m_bytes; }

private:
    static constexpr int kMargin = 5; // so nothing is aligned
    static int Half(int size, bool isHalf) { return isHalf ? (size + 1) / 2 : size; }

    PicturePlanes m_planes;
    std::array<std::vector<std::uint8_t>, 3> m_bytes;
    std::array<int, 3> m_widths{};
    std::array<int, 3> m_heights{};
};

Picture Converted(const Frame& frame, PlaneFormat format, YuvMatrix matrix)
{
    Picture picture(format, frame.width, frame.height);
    PicturePlanes planes = picture.Planes();
    planes.matrix = matrix;
    ConvertPixels(frame, {0, 0, frame.width, frame.height}, planes);
    return picture;
}

Picture Converted(const Frame& frame, PlaneFormat format,
                  Instructions instructions = Instructions::Widest)
{
    Picture picture(format, frame.width, frame.height);
    ConvertPixels(frame, {0, 0, frame.width, frame.height}, picture.Planes(), instructions);
    return picture;
}

void SetPixel(Frame& frame, int x, int y, int r, int g, int b)
{
    std::uint8_t* pixel = frame.Pixel(x, y);
    pixel[0] = std::uint8_t(r);
    pixel[1] = std::uint8_t(g);
    pixel[2] = std::uint8_t(b);
    pixel[3] = std::uint8_t(x * 7 + y); // must not matter
}

Frame Flat(int width, int height, int r, int g, int b)
{
    Frame frame(width, height);
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            SetPixel(frame, x, y, r, g, b);
        }
    }
    return frame;
}

/// The definition as a fraction: value = zero + numerator / denominator.
struct Exact
{
    std::int64_t zero;
    std::int64_t red;
    std::int64_t green;
    std::int64_t blue;
    std::int64_t denominator;

    double Error(int sample, int r, int g, int b) const
    {
        const std::int64_t numerator = red * r + green * g + blue * b;
        const std::int64_t twice = (sample - zero) * denominator - numerator;
        return double(std::abs(twice)) / double(denominator);
    }
    double Value(double r, double g, double b) const
    {
        return double(zero) +
               (double(red) * r + double(green) * g + double(blue) * b) / double(denominator);
    }
};

constexpr Exact kExact[3] = {
    {16, 219 * 2126, 219 * 7152, 219 * 722, 255 * 10000},
    {128, -224 * 2126, -224 * 7152, 224 * (10000 - 722), 255 * 18556},
    {128, 224 * (10000 - 2126), -224 * 7152, -224 * 722, 255 * 15748},
};

/// A row for each green, in which each blue has `repeats` pixels.
Frame EveryGreenAndBlue(int red, int repeats)
{
    Frame frame(256 * repeats, 256);
    for (int green = 0; green < 256; ++green)
    {
        for (int x = 0; x < 256 * repeats; ++x)
        {
            SetPixel(frame, x, green, red, green, x / repeats);
        }
    }
    return frame;
}

constexpr Exact kExactOf601[3] = {
    {16, 219 * 299, 219 * 587, 219 * 114, 255 * 1000},
    {128, -224 * 299, -224 * 587, 224 * (1000 - 114), 255 * 1772},
    {128, 224 * (1000 - 299), -224 * 587, -224 * 114, 255 * 1402},
};

TEST(YuvConvert, RoundsEveryColourToNearestValueOfBt601)
{
    double worst = 0.0;
    for (int red = 0; red < 256; ++red)
    {
        const Picture picture =
            Converted(EveryGreenAndBlue(red, 1), PlaneFormat::Yuv444, YuvMatrix::Bt601);
        for (int green = 0; green < 256; ++green)
        {
            for (int blue = 0; blue < 256; ++blue)
            {
                for (int i = 0; i < 3; ++i)
                {
                    const int sample = picture.At(i, blue, green);
                    worst = std::max(worst, kExactOf601[i].Error(sample, red, green, blue));
                }
            }
        }
    }
    EXPECT_LE(worst, 0.50001);
}

TEST(YuvConvert, ConvertsFlatAreasToValuesOfBt601In420)
{
    const struct
    {
        int rgb[3];
        int ycc[3];
    } cases[] = {
        {{0, 0, 0}, {16, 128, 128}},   {{255, 255, 255}, {235, 128, 128}},
        {{255, 0, 0}, {81, 90, 240}},  {{0, 255, 0}, {145, 54, 34}},
        {{0, 0, 255}, {41, 240, 110}}, {{90, 90, 90}, {93, 128, 128}},
    };
    for (const auto& c : cases)
    {
        const Picture picture = Converted(Flat(4, 4, c.rgb[0], c.rgb[1], c.rgb[2]),
                                          PlaneFormat::Yuv420, YuvMatrix::Bt601);
        for (int i = 0; i < 3; ++i)
        {
            EXPECT_EQ(picture.At(i, 1, 1), c.ycc[i]);
        }
    }
}

TEST(YuvConvert, RoundsEveryColourToNearestValue)
{
    std::array<double, 3> worst{};
    for (int red = 0; red < 256; ++red)
    {
        const Picture picture = Converted(EveryGreenAndBlue(red, 1), PlaneFormat::Yuv444);
        for (int green = 0; green < 256; ++green)
        {
            for (int blue = 0; blue < 256; ++blue)
            {
                for (std::size_t i = 0; i < 3; ++i)
                {
                    const double error =
                        kExact[i].Error(picture.At(int(i), blue, green), red, green, blue);
                    worst[i] = std::max(worst[i], error);
                }
            }
        }
    }
    EXPECT_LE(worst[0], 0.500003);
    EXPECT_LE(worst[1], 0.5);
    EXPECT_LE(worst[2], 0.5);
}

TEST(YuvConvert, KeepsEveryColourOfFlatAreasIn420)
{
    std::array<double, 3> worst{};
    for (int red = 0; red < 256; ++red)
    {
        // Each row by itself; six pixels of a colour, so that one sample of three sees nothing
        // else.
        const Frame colours = EveryGreenAndBlue(red, 6);
        for (int green = 0; green < 256; ++green)
        {
            Frame row(colours.width, 1);
            std::copy_n(colours.Pixel(0, green), row.rgba.size(), row.rgba.data());
            const Picture picture = Converted(row, PlaneFormat::Yuv420);
            for (int blue = 0; blue < 256; ++blue)
            {
                for (std::size_t i = 0; i < 3; ++i)
                {
                    const int x = i == 0 ? blue * 6 : blue * 3 + 1;
                    const double error =
                        kExact[i].Error(picture.At(int(i), x, 0), red, green, blue);
                    worst[i] = std::max(worst[i], error);
                }
            }
        }
    }
    EXPECT_LE(worst[0], 0.500003);
    EXPECT_LE(worst[1], 0.5002);
    EXPECT_LE(worst[2], 0.5002);
}

TEST(YuvConvert, ConvertsKnownColoursToKnownValues)
{
    const struct
    {
        int rgb[3];
        int ycc[3];
    } cases[] = {
        {{0, 0, 0}, {16, 128, 128}},     {{255, 255, 255}, {235, 128, 128}},
        {{255, 0, 0}, {63, 102, 240}},   {{0, 255, 0}, {173, 42, 26}},
        {{0, 0, 255}, {32, 240, 118}},   {{0, 255, 255}, {188, 154, 16}},
        {{255, 255, 0}, {219, 16, 138}},
    };
    for (const auto& c : cases)
    {
        for (const PlaneFormat format : {PlaneFormat::Yuv420, PlaneFormat::Yuv444})
        {
            const Picture picture = Converted(Flat(4, 4, c.rgb[0], c.rgb[1], c.rgb[2]), format);
            for (int i = 0; i < 3; ++i)
            {
                EXPECT_EQ(picture.At(i, 1, 1), c.ycc[i]);
            }
        }
    }
}

TEST(YuvConvert, GivesGreysNoChroma)
{
    for (int grey = 0; grey < 256; ++grey)
    {
        const Frame frame = Flat(3, 3, grey, grey, grey);
        for (const PlaneFormat format : {PlaneFormat::Yuv420, PlaneFormat::Yuv444})
        {
            const Picture picture = Converted(frame, format);
            EXPECT_EQ(picture.At(1, 1, 1), 128);
            EXPECT_EQ(picture.At(2, 1, 1), 128);
        }
    }
}

/// The mean of two rows of five pixels, by the definition.
double ExactChroma(const Frame& frame, int plane, int x, int y)
{
    double sum = 0.0;
    for (const int dy : {0, 1})
    {
        for (int dx = -2; dx <= 2; ++dx)
        {
            const double weight = (dx == 0 ? 6 : std::abs(dx) == 1 ? 2 : -1) / 16.0;
            const std::uint8_t* p = frame.Pixel(std::clamp(2 * x + dx, 0, frame.width - 1),
                                                std::min(2 * y + dy, frame.height - 1));
            sum += weight * kExact[plane].Value(p[0], p[1], p[2]);
        }
    }
    return std::clamp(sum, 1.0, 254.0);
}

double WorstChroma(const Frame& frame)
{
    const Picture picture = Converted(frame, PlaneFormat::Yuv420);
    double worst = 0.0;
    for (int y = 0; y < picture.Height(1); ++y)
    {
        for (int x = 0; x < picture.Width(1); ++x)
        {
            for (const int plane : {1, 2})
            {
                const double exact = ExactChroma(frame, plane, x, y);
                worst = std::max(worst, std::abs(picture.At(plane, x, y) - exact));
            }
        }
    }
    return worst;
}

TEST(YuvConvert, FiltersChromaOverTwoRowsOfFivePixels)
{
    for (const auto& [width, height] : {std::pair(64, 48), {1, 1}, {2, 2}, {3, 5}, {1151, 7}})
    {
        EXPECT_LE(WorstChroma(Noise(width, height, width)), 0.501) << width << "x" << height;
    }
}

TEST(YuvConvert, KeepsChromaExactAtStrongestEdges)
{
    // Blue, yellow, red and cyan are the ends of Cb and Cr.
    const int ends[4][3] = {{0, 0, 255}, {255, 255, 0}, {255, 0, 0}, {0, 255, 255}};
    for (const auto& [one, other] : {std::pair(0, 1), {1, 0}, {2, 3}, {3, 2}})
    {
        for (int columns = 1; columns <= 4; ++columns)
        {
            Frame frame = Flat(32, 4, ends[one][0], ends[one][1], ends[one][2]);
            for (int x = 16; x < 32; x += 2 * columns)
            {
                FillRect(frame, x, 0, x + columns, 4,
                         {std::uint8_t(ends[other][0]), std::uint8_t(ends[other][1]),
                          std::uint8_t(ends[other][2])});
            }
            EXPECT_LE(WorstChroma(frame), 0.501);
        }
    }
}

TEST(YuvConvert, CopiesColoursIntoRgbPlanes)
{
    const Frame frame = Noise(67, 5, 1);
    const Picture gbr = Converted(frame, PlaneFormat::Gbr);
    const Picture bgr0 = Converted(frame, PlaneFormat::Bgr0);
    for (int y = 0; y < frame.height; ++y)
    {
        for (int x = 0; x < frame.width; ++x)
        {
            const std::uint8_t* p = frame.Pixel(x, y);
            ASSERT_THAT((std::array{gbr.At(2, x, y), gbr.At(0, x, y), gbr.At(1, x, y)}),
                        ElementsAre(p[0], p[1], p[2]));
            ASSERT_THAT((std::array{bgr0.At(0, 4 * x + 2, y), bgr0.At(0, 4 * x + 1, y),
                                    bgr0.At(0, 4 * x, y), bgr0.At(0, 4 * x + 3, y)}),
                        ElementsAre(p[0], p[1], p[2], 0));
        }
    }
}

class Random
{
public:
    /// From `low` to `high`, both included.
    int Between(int low, int high)
    {
        m_state = m_state * 6364136223846793005u + 1442695040888963407u;
        return low + int((m_state >> 33) % std::uint64_t(high - low + 1));
    }

private:
    std::uint64_t m_state = 1;
};

PixelBounds RandomBounds(Random& random, int width, int height)
{
    const int x = random.Between(0, width - 1);
    const int y = random.Between(0, height - 1);
    return {x, y, random.Between(x + 1, width), random.Between(y + 1, height)};
}

TEST(YuvConvert, UpdatesPartsAsConvertingTheWholeFrame)
{
    Random random;
    for (int round = 0; round < 1000; ++round)
    {
        const int width = random.Between(1, round % 10 == 0 ? 1200 : 40);
        const int height = random.Between(1, 20);
        const Frame before = Noise(width, height, 2 * round);
        const Frame other = Noise(width, height, 2 * round + 1);
        Frame after = before;
        std::vector<PixelBounds> changed;
        for (int i = random.Between(1, 3); i > 0; --i)
        {
            const PixelBounds part = RandomBounds(random, width, height);
            for (int y = part.y0; y < part.y1; ++y)
            {
                std::copy_n(other.Pixel(part.x0, y), (part.x1 - part.x0) * 4,
                            after.Pixel(part.x0, y));
            }
            changed.push_back(part);
        }
        for (const PlaneFormat format : kFormats)
        {
            const Picture picture = Converted(before, format);
            for (const PixelBounds& part : changed)
            {
                ConvertPixels(after, part, picture.Planes());
            }
            ASSERT_TRUE(picture == Converted(after, format)) << width << "x" << height;
        }
    }
}

TEST(YuvConvert, MakesEqualBitsWithWideInstructions)
{
    for (const int width : {1, 2, 7, 8, 31, 64, 513, 1029})
    {
        const Frame frame = Noise(width, 5, width);
        for (const PlaneFormat format : kFormats)
        {
            EXPECT_TRUE(Converted(frame, format, Instructions::Any) ==
                        Converted(frame, format, Instructions::Widest))
                << width;
        }
    }
}

TEST(YuvConvert, WritesNothingOutsideThePicture)
{
    for (const PlaneFormat format : kFormats)
    {
        for (const int size : {1, 2, 5, 33, 514})
        {
            const Frame frame = Noise(size, size, size);
            const Picture picture(format, size, size);
            for (const PixelBounds nothing :
                 {PixelBounds{}, PixelBounds{3, 3, 2, 9}, PixelBounds{size, 0, size + 4, size},
                  PixelBounds{-9, -9, 0, 4}})
            {
                ConvertPixels(frame, nothing, picture.Planes());
            }
            EXPECT_TRUE(picture == Picture(format, size, size));
            constexpr int far = 2147483647;
            ConvertPixels(frame, {-far, -far, far, far}, picture.Planes());
            EXPECT_TRUE(picture == Converted(frame, format));
            EXPECT_THAT(picture.Surroundings(), Each(kUntouched));
        }
    }
}

} // namespace
