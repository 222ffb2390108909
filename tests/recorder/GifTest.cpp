// SPDX-License-Identifier: MIT
#include "../debugdraw/TemporaryFolder.h"
#include "TestFilm.h"

#include "GifPalette.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{

using namespace testfilm;
using boxreel::Color;
using boxreel::Frame;
using boxreel::GifPalette;
using boxreel::Quality;
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

TEST(GifPalette, KeepsTheIndicesOfColoursThatStayWhileOthersAreAdded)
{
    GifPalette palette;
    std::vector<std::uint8_t> first(100 * 2);
    std::vector<std::uint8_t> second(200 * 2);
    ASSERT_TRUE(palette.Map(Chart(0, 100), first.data(), 100));
    ASSERT_TRUE(palette.Map(Chart(0, 200), second.data(), 200));
    EXPECT_TRUE(std::equal(first.begin(), first.begin() + 100, second.begin()));
}

TEST(GifPalette, IsExactForEveryFrameOfAFilmThatHasMoreColoursThanAnyFrame)
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

TEST(GifPalette, KeepsAreasExactlyAndBlendsNearlyWhenThereAreTooManyColours)
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

TEST(GifPalette, TakesAColourThatTurnsUpLaterWhenItFillsAnArea)
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
    TemporaryFolder m_folder;
};

TEST_F(GifFilm, TimesAreRoundedOneByOneAndNeverDrift)
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

TEST_F(GifFilm, EverySecondFrameIsKeptOfSixtyASecond)
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

TEST_F(GifFilm, FramesOfDifferentPalettesComeBackExactly)
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

TEST_F(GifFilm, LosslessIsRefusedWhenAFrameHasTooManyColours)
{
    {
        Result<VideoWriter> writer = VideoWriter::Open(
            m_folder / "film.gif", {.width = 32, .height = 32, .quality = Quality::Lossless});
        ASSERT_TRUE(writer);
        const Result<void> appended = writer->Append(Noise(32, 32, 0));
        ASSERT_FALSE(appended);
        EXPECT_EQ(appended.GetError().kind, boxreel::ErrorKind::Unusable);
        EXPECT_THAT(appended.GetError().message, testing::HasSubstr(".mkv"));
    }
    EXPECT_THAT(m_folder.Names(), testing::IsEmpty());
}

} // namespace
