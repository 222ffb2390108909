// SPDX-License-Identifier: MIT
#include "../base/TemporaryFolder.h"
#include "TestFilm.h"

#include <recorder/VideoReader.h>
#include <recorder/VideoWriter.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ostream>
#include <string>

/// Every format is decoded again and compared with the frames that were written.
namespace
{

using namespace testfilm;
using boxreel::Frame;
using boxreel::Quality;
using boxreel::Rational;
using boxreel::VideoSettings;

constexpr int kWidth = 160;
constexpr int kHeight = 96;
constexpr int kCount = 50; // more than the encoders hold back

/// What one format must give back.
struct Case
{
    const char* name;
    Quality quality;
    const char* codec;
    const char* pixelFormat;
    double clock; ///< what its times are rounded to [s]; 0: exact
    int maxError; ///< over all pixels, of 255; 0: bit-equal
    double meanError;
    const char* option = ""; ///< of VideoSettings: "av1", "vp9" or "444"

    VideoSettings Settings(const Rational& rate) const
    {
        VideoSettings settings;
        settings.framesPerSecond = rate;
        settings.quality = quality;
        const std::string asked = option;
        settings.chroma = asked == "444" ? boxreel::Chroma::Full : boxreel::Chroma::Half;
        settings.codec = asked == "444" ? "" : asked;
        return settings;
    }
};

void PrintTo(const Case& c, std::ostream* out)
{
    *out << c.name;
}

// Bounds of the largest and the mean error, of 255: what was measured and a tenth. Most of it is of
// 1-px lines in 4:2:0, where a line keeps its brightness and shares its colour with its neighbours
// (y4m, which no codec touches, has 33 and 0.59 of it); 4:4:4 shows what the codec alone does.
const Case kCases[] = {
    {"draft.mp4", Quality::Draft, "h264", "yuv420p", 0.0, 57, 0.72},
    {"standard.mp4", Quality::Standard, "h264", "yuv420p", 0.0, 50, 0.7},
    {"high.mp4", Quality::High, "h264", "yuv420p", 0.0, 50, 0.7},
    {"lossless.mp4", Quality::Lossless, "h264", "gbrp", 0.0, 0, 0.0},
    {"standard.mkv", Quality::Standard, "h264", "yuv420p", 0.001, 50, 0.7},
    {"lossless.mkv", Quality::Lossless, "ffv1", "bgr0", 0.001, 0, 0.0},
    {"draft.webm", Quality::Draft, "vp9", "yuv420p", 0.001, 48, 0.99},
    {"standard.webm", Quality::Standard, "vp9", "yuv420p", 0.001, 50, 0.75},
    {"high.webm", Quality::High, "vp9", "yuv420p", 0.001, 50, 0.7},
    {"lossless.webm", Quality::Lossless, "vp9", "gbrp", 0.001, 0, 0.0},
    {"standard.gif", Quality::Standard, "gif", "bgra", 0.01, 0, 0.0},
    {"lossless.gif", Quality::Lossless, "gif", "bgra", 0.01, 0, 0.0},
    {"frames-####.png", Quality::Standard, "png", "rgba", 0.0, 0, 0.0},
    {"whole-colours.mp4", Quality::Standard, "h264", "yuv444p", 0.0, 36, 0.181, "444"},
    {"whole-colours.webm", Quality::Standard, "vp9", "yuv444p", 0.001, 10, 0.086, "444"},
    {"draft-av1.webm", Quality::Draft, "libdav1d", "yuv420p", 0.001, 49, 0.75, "av1"},
    {"standard-av1.webm", Quality::Standard, "libdav1d", "yuv420p", 0.001, 47, 0.69, "av1"},
    {"standard-av1.mp4", Quality::Standard, "libdav1d", "yuv420p", 0.0, 47, 0.69, "av1"},
    {"high-av1.mkv", Quality::High, "libdav1d", "yuv420p", 0.001, 47, 0.66, "av1"},
    {"lossless-av1.mkv", Quality::Lossless, "libdav1d", "gbrp", 0.001, 0, 0.0, "av1"},
    {"standard-vp9.mkv", Quality::Standard, "vp9", "yuv420p", 0.001, 49, 0.72, "vp9"},
    {"draft.apng", Quality::Draft, "apng", "rgb24", 0.0, 0, 0.0},
    {"standard.apng", Quality::Standard, "apng", "rgb24", 0.0, 0, 0.0},
    {"lossless.apng", Quality::Lossless, "apng", "rgb24", 0.0, 0, 0.0},
    {"draft.webp", Quality::Draft, "webp", "rgba", 0.001, 0, 0.0},
    {"lossless.webp", Quality::Lossless, "webp", "rgba", 0.001, 0, 0.0},
    {"standard.y4m", Quality::Standard, "rawvideo", "yuv420p", 0.0, 37, 0.65},
    {"whole-colours.y4m", Quality::Standard, "rawvideo", "yuv444p", 0.0, 1, 0.024, "444"},
    {"lossless.nut", Quality::Lossless, "rawvideo", "rgb24", 0.0, 0, 0.0},
};

class EveryFormat : public testing::TestWithParam<Case>
{
protected:
    TemporaryFolder m_folder;
};

TEST_P(EveryFormat, ReturnsTheWrittenFrames)
{
    const Case& c = GetParam();
    const std::vector<Frame> frames = Drawings(kWidth, kHeight, kCount);
    const Rational rate = std::string(c.codec) == "png" ? Rational{60, 1} : Rational{25, 1};
    WriteFilm(m_folder / c.name, c.Settings(rate), frames);
    const Film film = ReadFilm(m_folder / c.name);
    ASSERT_EQ(film.frames.size(), std::size_t(kCount));
    EXPECT_EQ(film.info.width, kWidth);
    EXPECT_EQ(film.info.height, kHeight);
    if (std::string(c.codec) != "webp") // which stores times only
    {
        EXPECT_EQ(film.info.framesPerSecond, rate);
    }
    EXPECT_EQ(film.info.codec, c.codec);
    EXPECT_EQ(film.info.pixelFormat, c.pixelFormat);
    for (std::size_t k = 0; k < film.times.size(); ++k)
    {
        EXPECT_EQ(film.times[k], double(k) * double(rate.den) / double(rate.num)) << "frame " << k;
    }
    const Difference difference = Compare(film.frames, frames);
    EXPECT_LE(difference.max, c.maxError);
    EXPECT_LE(difference.mean, c.meanError);
    RecordProperty("max", difference.max);
    RecordProperty("mean", std::to_string(difference.mean));
}

// Patches of the colours of a drawing, each larger than any block of a codec: what is left is the
// matrix, the range and the tags.
TEST_P(EveryFormat, KeepsFlatColoursWithinTwoOf255)
{
    const boxreel::Color colors[] = {kOutline,        kFill,         kGround,
                                     {255, 255, 255}, {230, 40, 40}, {40, 60, 230}};
    Frame frame(384, 256);
    for (int i = 0; i < 6; ++i)
    {
        FillRect(frame, i % 3 * 128, i / 3 * 128, i % 3 * 128 + 128, i / 3 * 128 + 128, colors[i]);
    }
    const Case& c = GetParam();
    WriteFilm(m_folder / c.name, c.Settings({50, 1}), {frame, frame, frame});
    const Film film = ReadFilm(m_folder / c.name);
    const bool joinsEqualFrames = std::string(c.codec) == "webp";
    ASSERT_EQ(film.frames.size(), joinsEqualFrames ? 1u : 3u);
    for (const Frame& read : film.frames)
    {
        for (int i = 0; i < 6; ++i)
        {
            const int x = i % 3 * 128 + 64;
            const int y = i / 3 * 128 + 64;
            for (int channel = 0; channel < 3; ++channel)
            {
                EXPECT_NEAR(read.Pixel(x, y)[channel], frame.Pixel(x, y)[channel], 2)
                    << "patch " << i << ", channel " << channel;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(VideoWriter, EveryFormat, testing::ValuesIn(kCases),
                         [](const testing::TestParamInfo<Case>& test) {
                             std::string name;
                             for (const char* c = test.param.name; *c != '\0'; ++c)
                             {
                                 name +=
                                     std::isalnum(static_cast<unsigned char>(*c)) != 0 ? *c : '_';
                             }
                             return name;
                         });

TEST(CodecChoices, AreAcceptedOnlyByFormatsThatTheyName)
{
    ASSERT_FALSE(boxreel::CodecChoices().empty());
    for (const boxreel::CodecChoice& choice : boxreel::CodecChoices())
    {
        VideoSettings settings;
        settings.codec = choice.name;
        settings.quality = choice.name == "ffv1" ? Quality::Lossless : Quality::Standard;
        for (const std::string& end : boxreel::VideoEnds())
        {
            const bool isNamed =
                std::find(choice.ends.begin(), choice.ends.end(), end) != choice.ends.end();
            EXPECT_EQ(bool(boxreel::CheckVideoPath("film" + end, settings)), isNamed)
                << choice.name << end;
        }
    }
}

} // namespace
