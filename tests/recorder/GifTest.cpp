// SPDX-License-Identifier: MIT
#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "ShownFrames.h"
#include "TestFilm.h"

#include "GifPalette.h"

#include <recorder/JoinFilms.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace
{

using namespace testfilm;
using boxreel::Color;
using boxreel::Frame;
using boxreel::GifPalette;
using boxreel::Quality;
using boxreel::RefusesWith;
using boxreel::Result;
using boxreel::VideoWriter;

/// What a viewer sees of a mapped frame.
Frame Shown(const GifPalette& palette, const std::vector<std::uint8_t>& indices, int width,
            int height)
{
    Frame frame(width, height);
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
        const std::uint32_t color = palette.Colors()[indices[i]];
        frame.rgba[i * 4] = std::uint8_t(color >> 16);
        frame.rgba[i * 4 + 1] = std::uint8_t(color >> 8);
        frame.rgba[i * 4 + 2] = std::uint8_t(color);
        frame.rgba[i * 4 + 3] = 255;
    }
    return frame;
}

/// `count` different colours in a row of squares, starting with the one numbered `first`.
Frame Chart(int first, int count)
{
    Frame frame(count, 2);
    for (int i = 0; i < count; ++i)
    {
        const int n = first + i;
        FillRect(frame, i, 0, i + 1, 2,
                 {std::uint8_t(n * 7 % 256), std::uint8_t(n / 256 * 40 + n % 16),
                  std::uint8_t(n * 13 % 256)});
    }
    return frame;
}

TEST(GifPalette, KeepsTwoHundredAndFiftySixColoursExactly)
{
    GifPalette palette;
    const Frame chart = Chart(0, 256);
    std::vector<std::uint8_t> indices(256 * 2);
    EXPECT_TRUE(palette.Map(chart, indices.data(), 256));
    EXPECT_EQ(Shown(palette, indices, 256, 2), chart);
}

TEST(GifPalette, KeepsIndicesWhenColoursAreAdded)
{
    GifPalette palette;
    std::vector<std::uint8_t> first(100 * 2);
    std::vector<std::uint8_t> second(200 * 2);
    ASSERT_TRUE(palette.Map(Chart(0, 100), first.data(), 100));
    ASSERT_TRUE(palette.Map(Chart(0, 200), second.data(), 200));
    EXPECT_TRUE(std::equal(first.begin(), first.begin() + 100, second.begin()));
}

TEST(GifPalette, IsExactWhenFilmHasMoreThan256Colours)
{
    GifPalette palette;
    for (int k = 0; k < 20; ++k)
    {
        const Frame chart = Chart(k * 50, 200);
        std::vector<std::uint8_t> indices(200 * 2);
        EXPECT_TRUE(palette.Map(chart, indices.data(), 200)) << k;
        EXPECT_EQ(Shown(palette, indices, 200, 2), chart) << k;
    }
}

/// Blends of four flat colours along slanted edges, as a rendered drawing has them: far more than
/// 256 colours.
Frame Blends(int shift)
{
    Frame frame = Drawing(320, 200, shift);
    for (int y = 40; y < 180; ++y)
    {
        for (int x = 10; x < 310; ++x)
        {
            const Color from = y < 110 ? kOutline : kGround;
            const double t = 0.5 + 0.5 * std::sin(0.05 * (x + shift) + 0.13 * y);
            const auto mix = [t](int a, int b) { return std::uint8_t(a + (b - a) * t); };
            FillRect(frame, x, y, x + 1, y + 1,
                     {mix(from.r, kFill.r / 2), mix(from.g, kFill.g), mix(from.b, (x * 7) % 256)});
        }
    }
    return frame;
}

TEST(GifPalette, ApproximatesBlendsOnlyWhenColoursOverflow)
{
    GifPalette palette;
    for (int shift = 0; shift < 10; ++shift)
    {
        const Frame frame = Blends(shift);
        std::vector<std::uint8_t> indices(320 * 200);
        EXPECT_FALSE(palette.Map(frame, indices.data(), 320));
        const Frame shown = Shown(palette, indices, 320, 200);
        EXPECT_EQ(std::vector<std::uint8_t>(shown.Pixel(20 + 2 * shift, 18),
                                            shown.Pixel(20 + 2 * shift, 18) + 3),
                  (std::vector<std::uint8_t>{kFill.r, kFill.g, kFill.b}));
        const Difference difference = Compare({shown}, {frame});
        EXPECT_LE(difference.mean, 4.0);
        EXPECT_LE(difference.max, 60);
    }
}

TEST(GifPalette, AddsLaterColoursThatFillAnArea)
{
    GifPalette palette;
    std::vector<std::uint8_t> indices(320 * 200);
    (void)palette.Map(Blends(0), indices.data(), 320);
    Frame frame = Blends(1);
    const Color asleep{0x4d, 0x4d, 0x99};
    FillRect(frame, 250, 5, 290, 35, asleep);
    (void)palette.Map(frame, indices.data(), 320);
    const std::uint32_t shown = palette.Colors()[indices[20 * 320 + 270]];
    EXPECT_EQ(shown, 0xff4d4d99u);
}

class GifFilm : public testing::Test
{
protected:
    std::uintmax_t SizeOf(const std::string& name, const boxreel::VideoSettings& settings,
                          const std::vector<Frame>& frames) const
    {
        WriteFilm(m_folder / name, settings, frames);
        return std::filesystem::file_size(m_folder / name);
    }

    TemporaryFolder m_folder;
};

/// `count` colours all over the picture, in an order that fills LZW's table over and over.
Frame Speckled(int width, int height, int number, int count)
{
    Frame frame = Noise(width, height, number);
    for (std::size_t i = 0; i < frame.rgba.size(); i += 4)
    {
        const int n = frame.rgba[i] % count;
        frame.rgba[i] = std::uint8_t(n);
        frame.rgba[i + 1] = std::uint8_t(255 - n);
        frame.rgba[i + 2] = std::uint8_t(n * 7);
    }
    return frame;
}

TEST_F(GifFilm, KeepsFramesOfAnyNumberOfColoursExactly)
{
    for (const int colors : {1, 2, 3, 4, 5, 16, 17, 255, 256})
    {
        SCOPED_TRACE(colors);
        std::vector<Frame> frames;
        for (int k = 0; k < 4; ++k)
        {
            frames.push_back(Speckled(251, 97, k, colors));
        }
        WriteFilm(m_folder / "film.gif",
                  {.framesPerSecond = {25, 1}, .quality = Quality::Lossless, .overwrite = true},
                  frames);
        EXPECT_EQ(ReadShown(m_folder / "film.gif", {25, 1}), frames);
    }
}

/// A box that moves over a picture, and in every frame a colour that no frame before had.
std::vector<Frame> EverNewColours(int count)
{
    std::vector<Frame> frames(std::size_t(count), Speckled(320, 180, 0, 100));
    for (int k = 0; k < count; ++k)
    {
        FillRect(frames[std::size_t(k)], k % 250, 20, k % 250 + 20, 40, kOutline);
        const int n = k % 250;
        FillRect(frames[std::size_t(k)], 300, 100, 310, 110,
                 {std::uint8_t(n), std::uint8_t(k / 250), 77});
    }
    return frames;
}

TEST_F(GifFilm, StoresOnlyChangesWhenThePaletteChanges)
{
    const std::uintmax_t one = SizeOf("one.gif", {}, EverNewColours(1));
    const std::uintmax_t all =
        SizeOf("all.gif", {.framesPerSecond = {25, 1}, .groupFrames = 1000}, EverNewColours(300));
    EXPECT_LT(all, 10 * one) << "whole frames are stored";
}

TEST_F(GifFilm, StoresAtMostOneMoreFrameForEachGroup)
{
    const std::vector<Frame> frames = EverNewColours(300);
    const boxreel::VideoSettings inGroups{.framesPerSecond = {25, 1}, .groupFrames = 100};
    const boxreel::VideoSettings asOne{.framesPerSecond = {25, 1}, .groupFrames = 1000};
    const std::uintmax_t one = SizeOf("one.gif", {}, {frames.back()});
    EXPECT_LE(SizeOf("groups.gif", inGroups, frames), SizeOf("whole.gif", asOne, frames) + 2 * one);
}

TEST_F(GifFilm, KeepsTimeOfFrameBeyondTheLongestDelay)
{
    const boxreel::VideoSettings settings{
        .width = 64, .height = 48, .framesPerSecond = {1, 1}, .groupFrames = 100000};
    VideoWriter writer = *VideoWriter::Open(m_folder / "film.gif", settings);
    ASSERT_TRUE(writer.Append(Drawing(64, 48, 0)));
    for (int k = 1; k < 2000; ++k)
    {
        ASSERT_TRUE(writer.Repeat());
    }
    ASSERT_TRUE(writer.Append(Drawing(64, 48, 9)));
    ASSERT_TRUE(writer.Close());
    const std::vector<Frame> shown = ReadShown(m_folder / "film.gif", {1, 1});
    ASSERT_EQ(shown.size(), 2001u);
    EXPECT_EQ(std::count(shown.begin(), shown.end(), Drawing(64, 48, 0)), 2000);
    EXPECT_EQ(shown.back(), Drawing(64, 48, 9));
}

TEST_F(GifFilm, StoresTheNumberOfPlays)
{
    const struct
    {
        int plays;
        std::string written;
    } cases[] = {{0, std::string("\3\1\0\0\0", 5)}, {2, std::string("\3\1\1\0\0", 5)}, {1, ""}};
    for (const auto& c : cases)
    {
        WriteFilm(m_folder / "film.gif", {.plays = c.plays, .overwrite = true},
                  Drawings(64, 48, 2));
        const std::string bytes = ReadBytes(m_folder / "film.gif");
        const std::size_t at = bytes.find("NETSCAPE2.0");
        EXPECT_EQ(at == std::string::npos ? "" : bytes.substr(at + 11, 5), c.written) << c.plays;
    }
}

TEST_F(GifFilm, EqualsWholeFilmWhenJoinedFromFastParts)
{
    const boxreel::Rational rate{60, 1}; // of which every second is kept
    const std::vector<Frame> frames = Drawings(64, 48, 47);
    const auto write = [&](const std::string& name, int first, int end) {
        WriteFilm(m_folder / name,
                  {.framesPerSecond = rate,
                   .groupFrames = 10,
                   .frames = boxreel::FrameRange({first, end - 1, 1})},
                  {frames.begin() + first, frames.begin() + end});
    };
    EXPECT_EQ(boxreel::PartLength("film.gif", {.framesPerSecond = rate, .groupFrames = 10}), 20);
    write("whole.gif", 0, 47);
    write("a.gif", 0, 20);
    write("b.gif", 20, 47);
    const Result<boxreel::JoinedFilm> joined =
        boxreel::JoinFilms({{m_folder / "a.gif", 0}, {m_folder / "b.gif", 20}},
                           m_folder / "film.gif", {.framesPerSecond = rate, .groupFrames = 10});
    ASSERT_TRUE(joined) << joined.GetError().Text();
    EXPECT_EQ(ReadBytes(m_folder / "film.gif"), ReadBytes(m_folder / "whole.gif"));
}

TEST_F(GifFilm, RoundsEachTimeWithoutDrift)
{
    WriteFilm(m_folder / "film.gif", {.framesPerSecond = {2997, 100}}, Drawings(64, 48, 300));
    const Film film = ReadFilm(m_folder / "film.gif");
    ASSERT_EQ(film.times.size(), 300u);
    for (std::size_t k = 0; k < film.times.size(); ++k)
    {
        EXPECT_EQ(film.times[k],
                  double(std::int64_t(std::floor(double(k) * 10000.0 / 2997.0 + 0.5))) / 100.0)
            << k;
    }
}

TEST_F(GifFilm, KeepsEverySecondFrameAtSixtyPerSecond)
{
    const std::vector<Frame> frames = Drawings(64, 48, 60);
    WriteFilm(m_folder / "film.gif", {.framesPerSecond = {60, 1}}, frames);
    const Film film = ReadFilm(m_folder / "film.gif");
    ASSERT_EQ(film.frames.size(), 30u);
    for (std::size_t k = 0; k < 30; ++k)
    {
        EXPECT_EQ(film.frames[k], frames[2 * k]);
        EXPECT_NEAR(film.times[k], double(k) / 30.0, 0.005);
    }
    EXPECT_EQ(film.info.framesPerSecond, (boxreel::Rational{30, 1}));
}

TEST_F(GifFilm, KeepsFramesOfDifferentPalettesExactly)
{
    std::vector<Frame> frames;
    for (int k = 0; k < 12; ++k)
    {
        frames.push_back(Chart(k * 40, 200));
    }
    WriteFilm(m_folder / "film.gif", {.framesPerSecond = {25, 1}, .quality = Quality::Lossless},
              frames);
    EXPECT_EQ(ReadFilm(m_folder / "film.gif").frames, frames);
}

TEST_F(GifFilm, RefusesLosslessFrameWithTooManyColours)
{
    {
        Result<VideoWriter> writer = VideoWriter::Open(
            m_folder / "film.gif", {.width = 32, .height = 32, .quality = Quality::Lossless});
        ASSERT_TRUE(writer);
        EXPECT_THAT(writer->Append(Noise(32, 32, 0)),
                    RefusesWith((m_folder / "film.gif").string(), ".mkv"));
    }
    EXPECT_THAT(m_folder.Names(), testing::IsEmpty());
}

} // namespace
