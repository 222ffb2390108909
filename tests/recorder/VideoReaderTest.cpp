// SPDX-License-Identifier: MIT
#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "TestFilm.h"

#include <recorder/VideoReader.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{

using namespace testfilm;
using boxreel::Fails;
using boxreel::Frame;
using boxreel::Quality;
using boxreel::Refuses;
using boxreel::Result;
using boxreel::VideoReader;
using testing::HasSubstr;

/// Reads to the end; what went wrong, if anything.
Result<int> CountFrames(const std::filesystem::path& path)
{
    Result<VideoReader> reader = VideoReader::Open(path);
    if (!reader)
    {
        return reader.GetError();
    }
    int count = 0;
    Frame frame;
    while (true)
    {
        const Result<bool> more = reader->Next(frame);
        if (!more)
        {
            return more.GetError();
        }
        if (!*more)
        {
            return count;
        }
        ++count;
    }
}

class VideoReaderTest : public testing::Test
{
protected:
    TemporaryFolder m_folder;
};

TEST_F(VideoReaderTest, ReadsColourTagsOfHdFromH264)
{
    for (const char* name : {"film.mp4", "film.mkv", "film.webm"})
    {
        WriteFilm(m_folder / name, {}, Drawings(64, 48, 10));
        const Film film = ReadFilm(m_folder / name);
        EXPECT_EQ(film.info.pixelFormat, "yuv420p");
        EXPECT_EQ(film.info.colorSpace, "bt709");
        EXPECT_EQ(film.info.colorPrimaries, "bt709");
        EXPECT_EQ(film.info.colorTransfer, "bt709");
        EXPECT_EQ(film.info.colorRange, "tv");
    }
}

/// The mean of reader minus writer over one colour, away from the border.
double MeanShift(const Frame& read, const Frame& written, int colour)
{
    double sum = 0.0;
    int count = 0;
    for (int y = 8; y < written.height - 8; ++y)
    {
        for (int x = 8; x < written.width - 8; ++x, ++count)
        {
            sum += read.Pixel(x, y)[colour] - written.Pixel(x, y)[colour];
        }
    }
    return sum / count;
}

/// Half a pixel to the side would be one of 255 here, up in one colour and down in the other.
TEST_F(VideoReaderTest, ReadsColoursAtTheirPlaces)
{
    Frame frame(128, 64);
    for (int y = 0; y < frame.height; ++y)
    {
        for (int x = 0; x < frame.width; ++x)
        {
            FillRect(frame, x, y, x + 1, y + 1,
                     {std::uint8_t(2 * x), 128, std::uint8_t(254 - 2 * x)});
        }
    }
    for (const char* name : {"film.mp4", "film.mkv", "film.webm"})
    {
        WriteFilm(m_folder / name, {.quality = Quality::High}, {frame, frame, frame});
        const Film film = ReadFilm(m_folder / name);
        ASSERT_EQ(film.frames.size(), 3u);
        EXPECT_NEAR(MeanShift(film.frames[1], frame, 0), 0.0, 0.3) << name;
        EXPECT_NEAR(MeanShift(film.frames[1], frame, 2), 0.0, 0.3) << name;
    }
}

TEST_F(VideoReaderTest, ReadsFullRangeRgbTagsOfLosslessFilms)
{
    for (const char* name : {"film.mp4", "film.mkv", "film.webm"})
    {
        WriteFilm(m_folder / name, {.quality = Quality::Lossless}, Drawings(64, 48, 10));
        const Film film = ReadFilm(m_folder / name);
        EXPECT_EQ(film.info.colorSpace, "gbr");
        EXPECT_EQ(film.info.colorTransfer, "iec61966-2-1");
        EXPECT_EQ(film.info.colorRange, "pc");
    }
}

TEST_F(VideoReaderTest, FindsIndexAtTheStartOfMp4)
{
    WriteFilm(m_folder / "film.mp4", {}, Drawings(64, 48, 30));
    const std::string bytes = ReadBytes(m_folder / "film.mp4");
    EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
    EXPECT_NE(bytes.find("mdat"), std::string::npos);
}

TEST_F(VideoReaderTest, AgreesWithFfprobe)
{
    if (std::system("command -v ffprobe > /dev/null 2>&1") != 0)
    {
        GTEST_SKIP() << "ffprobe is not installed (Debian: ffmpeg), so only our own reader has "
                        "looked at the film";
    }
    WriteFilm(m_folder / "film.mp4", {.framesPerSecond = {60, 1}}, Drawings(160, 90, 90));
    const std::string command =
        "ffprobe -v error -count_frames -show_entries "
        "stream=codec_name,width,height,pix_fmt,color_range,color_space,"
        "color_transfer,color_primaries,r_frame_rate,avg_frame_rate,nb_read_frames,duration -of "
        "default=noprint_wrappers=1 " +
        (m_folder / "film.mp4").string();
    FILE* pipe = popen(command.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::string said;
    char line[256];
    while (fgets(line, sizeof line, pipe) != nullptr)
    {
        said += line;
    }
    EXPECT_EQ(pclose(pipe), 0);
    for (const char* expected :
         {"codec_name=h264\n", "width=160\n", "height=90\n", "pix_fmt=yuv420p\n",
          "color_range=tv\n", "color_space=bt709\n", "color_transfer=bt709\n",
          "color_primaries=bt709\n", "r_frame_rate=60/1\n", "avg_frame_rate=60/1\n",
          "nb_read_frames=90\n", "duration=1.500000\n"})
    {
        EXPECT_THAT(said, HasSubstr(expected));
    }
}

TEST_F(VideoReaderTest, ReadsMatroskaTimesWithoutDrift)
{
    for (const char* name : {"film.mkv", "film.webm"})
    {
        WriteFilm(m_folder / name, {.framesPerSecond = {30000, 1001}, .quality = Quality::Draft},
                  Drawings(64, 48, 200));
        const Film film = ReadFilm(m_folder / name);
        ASSERT_EQ(film.times.size(), 200u);
        for (std::size_t k = 0; k < film.times.size(); ++k)
        {
            EXPECT_NEAR(film.times[k], double(k) * 1001.0 / 30000.0, 0.00050001)
                << name << " " << k;
        }
    }
}

TEST_F(VideoReaderTest, ReadsExactTimesOfMp4AtAnyRate)
{
    for (const boxreel::Rational rate :
         {boxreel::Rational{30000, 1001}, {2997, 100}, {1, 7}, {1000, 1}, {12345, 678}})
    {
        WriteFilm(m_folder / "film.mp4",
                  {.framesPerSecond = rate, .quality = Quality::Draft, .overwrite = true},
                  Drawings(64, 48, 40));
        const Film film = ReadFilm(m_folder / "film.mp4");
        ASSERT_EQ(film.times.size(), 40u);
        EXPECT_EQ(film.info.framesPerSecond.num * rate.den,
                  film.info.framesPerSecond.den * rate.num);
        for (std::size_t k = 0; k < film.times.size(); ++k)
        {
            EXPECT_EQ(film.times[k], double(std::int64_t(k) * rate.den) / double(rate.num)) << k;
        }
    }
}

/// libav rounds how long each frame stays to 1/100000 s and adds that up.
TEST_F(VideoReaderTest, ReadsAnimatedPngTimesWithoutDrift)
{
    constexpr int kFrames = 6000; // in which that comes to more than a frame
    WriteFilm(m_folder / "film.apng", {.framesPerSecond = {60, 1}, .quality = Quality::Draft},
              Drawings(40, 32, kFrames));
    const Film film = ReadFilm(m_folder / "film.apng");
    ASSERT_EQ(film.times.size(), std::size_t(kFrames));
    EXPECT_EQ(film.times.back(), double(kFrames - 1) / 60.0);
}

/// Its encoder leaves them out.
TEST_F(VideoReaderTest, ReadsEqualFramesOfAnimatedPng)
{
    std::vector<Frame> frames = Drawings(64, 48, 12);
    frames[3] = frames[4] = frames[2];
    frames[10] = frames[11] = frames[9];
    WriteFilm(m_folder / "film.apng", {.framesPerSecond = {25, 1}}, frames);
    EXPECT_EQ(ReadFilm(m_folder / "film.apng").frames, frames);
}

TEST_F(VideoReaderTest, NamesMissingAndForeignFiles)
{
    WriteBytes(m_folder / "text.mp4", "this is not a film\n");
    WriteBytes(m_folder / "empty.mp4", "");
    WriteBytes(m_folder / "noise.mkv",
               std::string(reinterpret_cast<const char*>(Noise(64, 64, 1).rgba.data()), 9999));
    WriteBytes(m_folder / "list.m3u8", "#EXTM3U\n#EXTINF:1,\nother.ts\n");
    std::filesystem::create_directory(m_folder / "folder.mp4");
    for (const char* name : {"missing.mp4", "text.mp4", "empty.mp4", "noise.mkv", "list.m3u8",
                             "folder.mp4", "missing-##.png"})
    {
        const Result<VideoReader> reader = VideoReader::Open(m_folder / name);
        EXPECT_THAT(reader, Refuses((m_folder / name).string()));
    }
}

/// A film cut at any length is an Error that names it: at Open, or when the reader comes to the
/// cut.
TEST_F(VideoReaderTest, RefusesTruncatedFilms)
{
    for (const char* name :
         {"film.mp4", "film.mkv", "film.webm", "film.gif", "film.apng", "film.webp"})
    {
        WriteFilm(m_folder / name, {.framesPerSecond = {25, 1}, .quality = Quality::Lossless},
                  Drawings(64, 48, 30));
        const std::string bytes = ReadBytes(m_folder / name);
        const std::filesystem::path cut = m_folder / (std::string("cut-") + name);
        for (std::size_t twentieths = 1; twentieths < 20; ++twentieths)
        {
            WriteBytes(cut, bytes.substr(0, bytes.size() * twentieths / 20));
            const Result<int> count = CountFrames(cut);
            ASSERT_FALSE(count) << name << " cut at " << twentieths << "/20 gave " << *count
                                << " frames";
            EXPECT_THAT(count, Fails(testing::_, cut.string()));
        }
    }
}

/// Flipped bytes may go unnoticed or be an Error, but nothing breaks and nothing but frames comes
/// out.
TEST_F(VideoReaderTest, DoesNotCrashOnDamagedFilms)
{
    for (const char* name : {"film.mp4", "film.mkv", "film.webm", "film.gif"})
    {
        WriteFilm(m_folder / name, {.framesPerSecond = {25, 1}}, Drawings(64, 48, 20));
        const std::string bytes = ReadBytes(m_folder / name);
        std::uint32_t state = 1;
        for (int round = 0; round < 40; ++round)
        {
            std::string damaged = bytes;
            for (int i = 0; i < 5; ++i)
            {
                state = state * 1664525u + 1013904223u;
                damaged[state % damaged.size()] = char(state >> 16);
            }
            WriteBytes(m_folder / "damaged", damaged);
            const Result<int> count = CountFrames(m_folder / "damaged");
            EXPECT_TRUE(!count || *count > 0);
        }
    }
}

TEST_F(VideoReaderTest, RefusesSequencesWithGapsOrOtherSizes)
{
    WriteFilm(m_folder / "p-###.png", {}, Drawings(64, 48, 5));
    EXPECT_EQ(*CountFrames(m_folder / "p-###.png"), 5);
    std::filesystem::remove(m_folder / "p-002.png");
    const std::string second = (m_folder / "p-002.png").string();
    EXPECT_THAT(CountFrames(m_folder / "p-###.png"), Refuses(second));
    WriteFilm(m_folder / "q-###.png", {}, Drawings(32, 48, 3));
    std::filesystem::rename(m_folder / "q-001.png", m_folder / "p-002.png");
    EXPECT_THAT(CountFrames(m_folder / "p-###.png"), Refuses(second));
}

} // namespace
