// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>
#include <recorder/VideoReader.h>
#include <recorder/VideoWriter.h>
#include <render/Frame.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Hand-made frames that look like the drawings films are made of, and films of them.
namespace testfilm
{

inline void FillRect(boxreel::Frame& frame, int x0, int y0, int x1, int y1, boxreel::Color color)
{
    for (int y = std::max(y0, 0); y < std::min(y1, frame.height); ++y)
    {
        for (int x = std::max(x0, 0); x < std::min(x1, frame.width); ++x)
        {
            std::uint8_t* pixel = frame.Pixel(x, y);
            pixel[0] = color.r;
            pixel[1] = color.g;
            pixel[2] = color.b;
            pixel[3] = 255;
        }
    }
}

inline constexpr boxreel::Color kFill{0x73, 0x59, 0x59};    ///< half of an awake body's colour
inline constexpr boxreel::Color kOutline{0xe6, 0xb3, 0xb3}; ///< an awake body's
inline constexpr boxreel::Color kGround{0x80, 0xe6, 0x80};  ///< a static body's

/// A box with an outline of one pixel that moves by two pixels a frame over a ground line: four
/// flat colours.
inline boxreel::Frame Drawing(int width, int height, int number)
{
    boxreel::Frame frame(width, height);
    FillRect(frame, 0, 0, width, height, {0, 0, 0});
    FillRect(frame, 0, height - 9, width, height - 8, kGround);
    const int x = 4 + 2 * number % (width - 30);
    FillRect(frame, x, 6, x + 24, 30, kOutline);
    FillRect(frame, x + 1, 7, x + 23, 29, kFill);
    return frame;
}

/// Every pixel differs from its neighbours; far more than 256 colours.
inline boxreel::Frame Noise(int width, int height, int number)
{
    boxreel::Frame frame(width, height);
    std::uint32_t state = 12345u + std::uint32_t(number) * 77777u;
    for (std::size_t i = 0; i < frame.rgba.size(); ++i)
    {
        state = state * 1664525u + 1013904223u;
        frame.rgba[i] = i % 4 == 3 ? 255 : std::uint8_t(state >> 24);
    }
    return frame;
}

inline std::vector<boxreel::Frame> Drawings(int width, int height, int count)
{
    std::vector<boxreel::Frame> frames;
    for (int i = 0; i < count; ++i)
    {
        frames.push_back(Drawing(width, height, i));
    }
    return frames;
}

/// Writes a whole film; a failure fails the test.
inline void WriteFilm(const std::filesystem::path& path, boxreel::VideoSettings settings,
                      const std::vector<boxreel::Frame>& frames)
{
    settings.width = frames.front().width;
    settings.height = frames.front().height;
    boxreel::Result<boxreel::VideoWriter> writer = boxreel::VideoWriter::Open(path, settings);
    ASSERT_TRUE(writer) << writer.GetError().Text();
    for (const boxreel::Frame& frame : frames)
    {
        const boxreel::Result<void> appended = writer->Append(frame);
        ASSERT_TRUE(appended) << appended.GetError().Text();
    }
    const boxreel::Result<void> closed = writer->Close();
    ASSERT_TRUE(closed) << closed.GetError().Text();
}

struct Film
{
    boxreel::VideoInfo info;
    std::vector<boxreel::Frame> frames;
    std::vector<double> times;
};

/// Reads a whole film; a failure fails the test.
inline Film ReadFilm(const std::filesystem::path& path)
{
    Film film;
    boxreel::Result<boxreel::VideoReader> reader = boxreel::VideoReader::Open(path);
    EXPECT_TRUE(reader) << (reader ? "" : reader.GetError().Text());
    while (reader)
    {
        boxreel::Frame frame;
        double seconds = -1.0;
        const boxreel::Result<bool> more = reader->Next(frame, &seconds);
        EXPECT_TRUE(more) << (more ? "" : more.GetError().Text());
        if (!more || !*more)
        {
            film.info = reader->Info();
            return film;
        }
        film.frames.push_back(std::move(frame));
        film.times.push_back(seconds);
    }
    return film;
}

/// Over all channels of all frames, of 255.
struct Difference
{
    int max = 0;
    double mean = 0.0;
};

inline Difference Compare(const std::vector<boxreel::Frame>& a,
                          const std::vector<boxreel::Frame>& b)
{
    Difference difference;
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    {
        for (std::size_t i = 0; i < std::min(a[k].rgba.size(), b[k].rgba.size()); ++i)
        {
            const int d = std::abs(int(a[k].rgba[i]) - int(b[k].rgba[i]));
            difference.max = std::max(difference.max, d);
            sum += d;
            count += i % 4 == 3 ? 0 : 1;
        }
    }
    difference.mean = count > 0 ? sum / count : 0.0;
    return difference;
}

} // namespace testfilm
