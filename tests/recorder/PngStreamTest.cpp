// SPDX-License-Identifier: MIT
#include <PngStream.h>

#include <base/WorkFolder.h>
#include <render/Png.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <random>
#include <span>
#include <thread>
#include <vector>

namespace
{

using namespace boxreel;

struct Pattern
{
    const char* name;
    std::function<std::uint32_t(int x, int y)> color; ///< the lowest byte is red
};

void PrintTo(const Pattern& pattern, std::ostream* out)
{
    *out << pattern.name;
}

/// Returns an opaque frame.
Frame Drawn(int width, int height, const Pattern& pattern)
{
    Frame frame(width, height);
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            const std::uint32_t color = pattern.color(x, y);
            std::uint8_t* pixel = frame.Pixel(x, y);
            pixel[0] = std::uint8_t(color);
            pixel[1] = std::uint8_t(color >> 8);
            pixel[2] = std::uint8_t(color >> 16);
            pixel[3] = 255;
        }
    }
    return frame;
}

std::uint32_t Noise(int x, int y)
{
    std::minstd_rand random(unsigned(x) * 7919u + unsigned(y) * 104729u + 1u);
    random.discard(2);
    return std::uint32_t(random());
}

/// Discs with soft edges on a plain background, as a scene looks.
std::uint32_t Discs(int x, int y)
{
    const int dx = x % 24 - 12 + y / 48 % 5;
    const int dy = y % 24 - 12;
    const int depth = 100 - dx * dx - dy * dy;
    const int cover = depth < -8 ? 0 : depth > 8 ? 255 : 128 + 15 * depth;
    return std::uint32_t(cover << 16 | cover / 2 << 8 | 23);
}

const Pattern kPatterns[] = {
    {"Plain", [](int, int) { return 0x221177u; }},
    {"Black", [](int, int) { return 0u; }},
    {"Ramps", [](int x, int y) { return std::uint32_t(x * 3 + y * 1021); }},
    {"Noise", Noise},
    {"Stripes", [](int x, int) { return x / 5 % 2 == 0 ? 0xFFFFFFu : 0x010203u; }},
    {"Discs", Discs},
    {"NoiseBelow", [](int x, int y) { return y < 3 ? 0x445566u : Noise(x, y); }},
};

std::vector<std::uint8_t> EncodeOnce(const Frame& frame)
{
    boxreel::PngStream stream;
    const std::span<const std::uint8_t> bytes = stream.Encode(frame);
    return {bytes.begin(), bytes.end()};
}

class PngStream : public testing::TestWithParam<Pattern>
{};

/// libpng checks both checksums and each code.
TEST_P(PngStream, IsReadPixelByPixelAtEverySize)
{
    const Result<WorkFolder> folder = WorkFolder::Create();
    ASSERT_TRUE(folder);
    const std::filesystem::path path = folder->Path() / "frame.png";
    boxreel::PngStream stream; // its buffers are those of the frame before
    // Rows longer than Deflate's window of 32,768 bytes are among them.
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(1, 300), std::pair(300, 1), std::pair(2, 2), std::pair(3, 5),
          std::pair(86, 3), std::pair(87, 41), std::pair(640, 360), std::pair(10922, 3),
          std::pair(10923, 3)})
    {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        const Frame frame = Drawn(width, height, GetParam());
        const std::span<const std::uint8_t> bytes = stream.Encode(frame);
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        const Result<Frame> read = ReadPng(path);
        ASSERT_TRUE(read) << read.GetError().Text();
        EXPECT_TRUE(*read == frame);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, PngStream, testing::ValuesIn(kPatterns),
                         [](const auto& one) { return one.param.name; });

TEST(PngStreams, AreNoLargerThanAtTheFastestLevelOfZlib)
{
    const Frame frame = Drawn(640, 360, {"Discs", Discs});
    EXPECT_LT(EncodeOnce(frame).size(), EncodePng(frame, 1)->size());
}

TEST(PngStreams, AreHardlyLargerThanThePixelsOfNoise)
{
    const Frame frame = Drawn(640, 360, {"Noise", Noise});
    EXPECT_LT(EncodeOnce(frame).size(), 640u * 360u * 3u * 101u / 100u);
}

TEST(PngStreams, AreRefusedForTransparentFrames)
{
    for (const int width : {20, 21})
    {
        Frame frame = Drawn(width, 10, {"Discs", Discs});
        frame.Pixel(width - 1, 9)[3] = 254;
        EXPECT_THAT(EncodeOnce(frame), testing::IsEmpty()) << width;
    }
}

TEST(PngStreams, HaveTheSameBytesInEveryThread)
{
    const Frame frame = Drawn(320, 180, {"Discs", Discs});
    const std::vector<std::uint8_t> expected = EncodeOnce(frame);
    std::vector<std::thread> threads;
    std::vector<std::vector<std::uint8_t>> found(4);
    for (std::vector<std::uint8_t>& bytes : found)
    {
        threads.emplace_back([&] { bytes = EncodeOnce(frame); });
    }
    for (std::thread& thread : threads)
    {
        thread.join();
    }
    for (const std::vector<std::uint8_t>& bytes : found)
    {
        EXPECT_EQ(bytes, expected);
    }
}

} // namespace
