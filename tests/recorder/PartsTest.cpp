// SPDX-License-Identifier: MIT
// Films in parts: interrupted and continued, made by several and joined, frames held.
#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "ShownFrames.h"
#include "TestFilm.h"

#include <recorder/JoinFilms.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace
{

using namespace testfilm;
using boxreel::FilmPart;
using boxreel::Frame;
using boxreel::FrameRange;
using boxreel::FrameRun;
using boxreel::Frames;
using boxreel::Quality;
using boxreel::RefusesWith;
using boxreel::Result;
using boxreel::StoredFrame;
using boxreel::VideoReader;
using boxreel::VideoSettings;
using boxreel::VideoWriter;

constexpr int kWidth = 96;
constexpr int kHeight = 64;
constexpr int kGroup = 10;
constexpr int kCount = 47;
constexpr boxreel::Rational kRate{25, 1};

/// What frame k of the film shows: it moves, and rests from frame 12 to 33.
Frame Content(std::int64_t k)
{
    return Drawing(kWidth, kHeight, int(k < 12 ? k : k < 34 ? 12 : k - 21));
}

struct Kind
{
    const char* extension;
    const char* codec;
};

void PrintTo(const Kind& kind, std::ostream* out)
{
    *out << kind.extension << " " << kind.codec;
}

class Parts : public testing::TestWithParam<Kind>
{
protected:
    std::filesystem::path Path(const std::string& stem) const
    {
        return m_folder / (stem + GetParam().extension);
    }

    VideoSettings Settings() const
    {
        VideoSettings settings;
        settings.width = kWidth;
        settings.height = kHeight;
        settings.framesPerSecond = kRate;
        settings.codec = GetParam().codec;
        settings.quality = settings.codec == "ffv1" ? Quality::Lossless : Quality::Standard;
        settings.groupFrames = kGroup;
        return settings;
    }

    /// Appends frames up to number `end`, as they follow those that the writer has.
    static void Continue(VideoWriter& writer, std::int64_t first, std::int64_t end)
    {
        for (std::int64_t k = first; k < end; ++k)
        {
            const bool isRepeat = k > first && Content(k) == Content(k - 1);
            const Result<void> done = isRepeat ? writer.Repeat() : writer.Append(Content(k));
            ASSERT_TRUE(done) << done.GetError().Text();
        }
    }

    void MakePart(const std::filesystem::path& path, std::int64_t first, std::int64_t end) const
    {
        VideoSettings settings = Settings();
        settings.frames = FrameRange(FrameRun{first, end - 1, 1});
        Result<VideoWriter> writer = VideoWriter::Open(path, settings);
        ASSERT_TRUE(writer) << writer.GetError().Text();
        Continue(*writer, first, end);
        const Result<void> closed = writer->Close();
        ASSERT_TRUE(closed) << closed.GetError().Text();
    }

    void ExpectSame(const std::string& stem) const
    {
        const std::vector<Frame> made = ReadShown(Path(stem), kRate);
        const std::vector<Frame> whole = ReadShown(Path("whole"), kRate);
        ASSERT_EQ(whole.size(), std::size_t(kCount));
        ASSERT_EQ(made.size(), whole.size());
        for (std::size_t k = 0; k < made.size(); ++k)
        {
            EXPECT_EQ(made[k], whole[k]) << "frame " << k;
        }
        ExpectSameStored(stem);
    }

    /// A frame that is held is stored as often, at the same times.
    void ExpectSameStored(const std::string& stem) const
    {
        const std::vector<StoredFrame> made = ReadStored(Path(stem));
        const std::vector<StoredFrame> whole = ReadStored(Path("whole"));
        ASSERT_EQ(made.size(), whole.size());
        for (std::size_t k = 0; k < made.size(); ++k)
        {
            EXPECT_EQ(made[k].seconds, whole[k].seconds) << "stored frame " << k;
            EXPECT_EQ(made[k].length, whole[k].length) << "stored frame " << k;
            EXPECT_EQ(made[k].frame, whole[k].frame) << "stored frame " << k;
        }
    }

    TemporaryFolder m_folder;
};

TEST_P(Parts, EqualTheWholeFilmWhenJoined)
{
    MakePart(Path("whole"), 0, kCount);
    MakePart(Path("a"), 0, 20);
    MakePart(Path("b"), 20, 30); // all of it rests
    MakePart(Path("c"), 30, kCount);
    const Result<boxreel::JoinedFilm> joined =
        JoinFilms({{Path("a"), 0}, {Path("b"), 20}, {Path("c"), 30}}, Path("film"), Settings());
    ASSERT_TRUE(joined && joined->isWhole) << joined.GetError().Text();
    EXPECT_EQ(joined->stored.value_or(kCount), std::int64_t(ReadStored(Path("film")).size()));
    ExpectSame("film");
}

TEST_P(Parts, LeaveNothingWhenJoiningIsStopped)
{
    MakePart(Path("a"), 0, 20);
    MakePart(Path("b"), 20, kCount);
    const std::vector<std::string> before = m_folder.Names();
    const std::vector<FilmPart> parts{{Path("a"), 0}, {Path("b"), 20}};
    bool isWhole = false;
    int question = 0; // the one that is answered with yes, as are all after it
    for (; !isWhole; ++question)
    {
        int asked = 0;
        const Result<boxreel::JoinedFilm> joined =
            JoinFilms(parts, Path("film"), Settings(), [&] { return asked++ >= question; });
        ASSERT_TRUE(joined) << joined.GetError().Text();
        isWhole = joined->isWhole;
        EXPECT_EQ(m_folder.Names().size(), before.size() + (isWhole ? 1 : 0)) << question;
    }
    EXPECT_GT(question, 4) << "it was hardly asked";
}

TEST_P(Parts, ContinueASuspendedFilmToTheSameFrames)
{
    MakePart(Path("whole"), 0, kCount);
    for (const std::int64_t end : {5, 10, 11, 29, 45})
    {
        SCOPED_TRACE(end);
        VideoSettings settings = Settings();
        settings.overwrite = true;
        {
            VideoWriter writer = *VideoWriter::Open(Path("film"), settings);
            Continue(writer, 0, end);
            const Result<void> suspended = writer.Suspend();
            ASSERT_TRUE(suspended) << suspended.GetError().Text();
        }
        EXPECT_EQ(ReadShown(Path("film.part"), kRate).size(), std::size_t(end))
            << "it can be played";
        settings.resume = true;
        Result<VideoWriter> opened = VideoWriter::Open(Path("film"), settings);
        ASSERT_TRUE(opened) << opened.GetError().Text();
        VideoWriter writer = std::move(*opened);
        EXPECT_EQ(writer.ResumedFrames(), (end - 1) / kGroup * kGroup);
        Continue(writer, writer.ResumedFrames(), kCount);
        const Result<void> closed = writer.Close();
        ASSERT_TRUE(closed) << closed.GetError().Text();
        ExpectSame("film");
        EXPECT_FALSE(std::filesystem::exists(Path("film.part")));
    }
}

TEST_P(Parts, ContinueAKilledFilmToTheSameFrames)
{
    MakePart(Path("whole"), 0, kCount);
    {
        VideoWriter writer = *VideoWriter::Open(Path("killed"), Settings());
        Continue(writer, 0, 45);
        // What a process that is killed leaves: neither trailer nor what the encoder still holds.
        std::filesystem::copy_file(Path("killed.part"), Path("film.part"));
    }
    VideoSettings settings = Settings();
    settings.resume = true;
    Result<VideoWriter> opened = VideoWriter::Open(Path("film"), settings);
    ASSERT_TRUE(opened) << opened.GetError().Text();
    VideoWriter writer = std::move(*opened);
    EXPECT_EQ(writer.ResumedFrames() % kGroup, 0);
    Continue(writer, writer.ResumedFrames(), kCount);
    ASSERT_TRUE(writer.Close());
    ExpectSame("film");
}

TEST_P(Parts, AreNotRestartedUnlessAllowed)
{
    {
        VideoWriter writer = *VideoWriter::Open(Path("film"), Settings());
        Continue(writer, 0, 15);
        ASSERT_TRUE(writer.Suspend());
    }
    const Result<VideoWriter> refused = VideoWriter::Open(Path("film"), Settings());
    EXPECT_THAT(refused, RefusesWith(Path("film").string(), "resume = true"));
    EXPECT_THAT(refused, RefusesWith(Path("film").string(), "overwrite = true"));
    EXPECT_EQ(ReadShown(Path("film.part"), kRate).size(), 15u) << "it is still there";
}

TEST_P(Parts, StoreHeldFramesAsTheTimingRequires)
{
    const std::string extension = GetParam().extension;
    const bool isAnimation = extension == ".gif" || extension == ".apng" || extension == ".webp";
    const auto countStored = [&](boxreel::FrameTiming timing) {
        VideoSettings settings = Settings();
        settings.timing = timing;
        settings.overwrite = true;
        VideoWriter writer = *VideoWriter::Open(Path("whole"), settings);
        Continue(writer, 0, kCount);
        EXPECT_TRUE(writer.Close());
        const int stored = int(ReadStored(Path("whole")).size());
        EXPECT_EQ(writer.StoredFrames().value_or(stored), stored);
        return stored;
    };
    const int few = kCount - 22 + 5; // it rests for 22 frames, in three groups
    EXPECT_LE(countStored(boxreel::FrameTiming::Variable), few);
    if (isAnimation)
    {
        EXPECT_LE(countStored(boxreel::FrameTiming::Automatic), few);
    }
    else
    {
        EXPECT_EQ(countStored(boxreel::FrameTiming::Automatic), kCount);
    }
    if (extension != ".webp") // its encoder never stores a frame twice
    {
        EXPECT_EQ(countStored(boxreel::FrameTiming::Constant), kCount);
    }
}

TEST_P(Parts, ContinueAFilmWithoutGroupsAtItsLastKeyframe)
{
    VideoSettings settings = Settings();
    settings.groupFrames = 0;
    settings.overwrite = true;
    settings.codecOptions = {};
    if (settings.codec == "h264" || settings.codec == "vp9" || settings.codec == "av1")
    {
        settings.codecOptions = {{"g", "15"}};
    }
    const auto open = [&] { return *VideoWriter::Open(Path("film"), settings); };
    {
        VideoWriter writer = open();
        Continue(writer, 0, 45);
        ASSERT_TRUE(writer.Suspend());
    }
    settings.resume = true;
    VideoWriter writer = open();
    const std::int64_t kept = writer.ResumedFrames();
    const bool hasGroups = settings.codec.empty(); // animations have
    EXPECT_TRUE(hasGroups ? kept == 0 : kept >= 15 && kept < 45) << kept;
    Continue(writer, kept, kCount);
    const Result<void> closed = writer.Close();
    ASSERT_TRUE(closed) << closed.GetError().Text();
    const std::vector<Frame> frames = ReadShown(Path("film"), kRate);
    ASSERT_EQ(frames.size(), std::size_t(kCount));
    std::vector<Frame> truth;
    for (std::int64_t k = 0; k < kCount; ++k)
    {
        truth.push_back(Content(k));
    }
    EXPECT_LE(Compare(frames, truth).mean, 1.5) << "each frame is in its place";
}

/// Writes 40 frames with one, two and more repetitions between moving ones. Returns all of them.
std::vector<Frame> WriteRepetitions(VideoWriter writer, bool areEncoded)
{
    std::vector<Frame> truth;
    for (int k = 0; k < 40; ++k)
    {
        const bool isRepeat = k % 4 == 3 || k % 10 == 4 || (k > 20 && k < 27);
        truth.push_back(isRepeat ? truth.back() : Drawing(kWidth, kHeight, k));
        EXPECT_TRUE(isRepeat && !areEncoded ? writer.Repeat() : writer.Append(truth.back()));
    }
    const Result<void> closed = writer.Close();
    EXPECT_TRUE(closed) << closed.GetError().Text();
    return truth;
}

TEST_P(Parts, ShowRepeatedFramesUnchanged)
{
    VideoSettings settings = Settings();
    settings.groupFrames = 0;
    settings.overwrite = true;
    for (const Quality quality :
         {Quality::Draft, Quality::Standard, Quality::High, Quality::Lossless})
    {
        if (settings.codec == "ffv1" && quality != Quality::Lossless)
        {
            continue;
        }
        SCOPED_TRACE(int(quality));
        settings.quality = quality;
        WriteRepetitions(*VideoWriter::Open(Path("encoded"), settings), true);
        const std::vector<Frame> encoded = ReadShown(Path("encoded"), kRate);
        const std::vector<Frame> truth =
            WriteRepetitions(*VideoWriter::Open(Path("film"), settings), false);
        const std::vector<Frame> frames = ReadShown(Path("film"), kRate);
        ASSERT_EQ(frames.size(), truth.size());
        for (std::size_t k = 1; k < truth.size(); ++k)
        {
            const bool isRepeat = truth[k] == truth[k - 1];
            // AV1 encodes it, and changes it.
            EXPECT_TRUE(!isRepeat || settings.codec == "av1" || frames[k] == frames[k - 1]) << k;
        }
        EXPECT_LE(Compare(frames, truth).mean, 1.2 * Compare(encoded, truth).mean);
    }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, Parts,
                         testing::Values(Kind{".mp4", "h264"}, Kind{".mkv", "h264"},
                                         Kind{".mkv", "vp9"}, Kind{".mkv", "ffv1"},
                                         Kind{".webm", "vp9"}, Kind{".mp4", "av1"},
                                         Kind{".mkv", "av1"}, Kind{".webm", "av1"},
                                         Kind{".gif", ""}, Kind{".apng", ""}, Kind{".webp", ""}),
                         [](const testing::TestParamInfo<Kind>& test) {
                             const std::string codec = test.param.codec;
                             return std::string(test.param.extension).substr(1) +
                                    (codec.empty() ? "" : "_" + codec);
                         });

std::int64_t Number(const std::string& bytes, std::size_t at)
{
    std::int64_t number = 0;
    for (std::size_t i = at; i < at + 4; ++i)
    {
        number = number * 256 + std::uint8_t(bytes.at(i));
    }
    return number;
}

/// Lengths of an MP4 in frames: what its header says, and what its packets last (ISO/IEC 14496-12,
/// the boxes mvhd, mdhd and stts), each behind its name, four bytes of version and, of mvhd and
/// mdhd, two dates.
struct Mp4Lengths
{
    double header = 0.0;
    double track = 0.0;
    double packets = 0.0;
};

Mp4Lengths LengthsOf(const std::filesystem::path& path)
{
    const std::string bytes = ReadBytes(path);
    const std::size_t movie = bytes.find("mvhd") + 16;
    const std::size_t track = bytes.find("mdhd") + 16;
    const std::size_t packets = bytes.find("stts") + 8;
    std::int64_t sum = 0;
    for (std::int64_t k = 0; k < Number(bytes, packets); ++k)
    {
        const std::size_t entry = packets + 4 + 8 * std::size_t(k);
        sum += Number(bytes, entry) * Number(bytes, entry + 4);
    }
    const auto frames = [](std::int64_t ticks, std::int64_t perSecond) {
        return double(ticks * kRate.num) / double(perSecond);
    };
    return {frames(Number(bytes, movie + 4), Number(bytes, movie)),
            frames(Number(bytes, track + 4), Number(bytes, track)),
            frames(sum, Number(bytes, track))};
}

TEST(Mp4, LastsAsLongAsItsFramesWithAHeldLastOne)
{
    const TemporaryFolder folder;
    constexpr int kMoving = 44;
    constexpr int kAll = 49;
    const auto make = [&](const std::string& name, std::int64_t first, std::int64_t end) {
        VideoSettings settings{.width = kWidth, .height = kHeight, .framesPerSecond = kRate};
        settings.groupFrames = kGroup;
        settings.frames = FrameRange(FrameRun{first, end - 1, 1});
        VideoWriter writer = *VideoWriter::Open(folder / name, settings);
        for (std::int64_t k = first; k < end; ++k)
        {
            const bool isRepeat = k > kMoving;
            ASSERT_TRUE(isRepeat ? writer.Repeat()
                                 : writer.Append(Drawing(kWidth, kHeight, int(k))));
        }
        ASSERT_TRUE(writer.Close());
    };
    make("whole.mp4", 0, kAll);
    make("a.mp4", 0, 20);
    make("b.mp4", 20, kAll);
    const Result<boxreel::JoinedFilm> joined =
        boxreel::JoinFilms({{folder / "a.mp4", 0}, {folder / "b.mp4", 20}}, folder / "joined.mp4",
                           {.framesPerSecond = kRate});
    ASSERT_TRUE(joined && joined->isWhole);
    for (const char* name : {"whole.mp4", "joined.mp4"})
    {
        SCOPED_TRACE(name);
        const Mp4Lengths lengths = LengthsOf(folder / name);
        EXPECT_EQ(lengths.header, kAll);
        EXPECT_EQ(lengths.track, kAll);
        EXPECT_EQ(lengths.packets, kAll);
        EXPECT_EQ(ReadShown(folder / name, kRate).size(), std::size_t(kAll));
    }
}

class JoinErrors : public testing::Test
{
protected:
    void Make(const std::string& name, VideoSettings settings) const
    {
        settings.framesPerSecond = {25, 1};
        WriteFilm(m_folder / name, settings, Drawings(kWidth, kHeight, 4));
    }

    std::string Refusal(const std::vector<std::string>& names, const std::string& whole) const
    {
        std::vector<FilmPart> parts;
        for (const std::string& name : names)
        {
            parts.push_back({m_folder / name, std::int64_t(parts.size()) * 4});
        }
        const Result<boxreel::JoinedFilm> joined = JoinFilms(parts, m_folder / whole, {});
        EXPECT_FALSE(joined);
        EXPECT_FALSE(std::filesystem::exists(m_folder / whole));
        return joined ? ""
                      : std::filesystem::path(joined.GetError().culprit.Text()).filename().string();
    }

    TemporaryFolder m_folder;
};

TEST_F(JoinErrors, NameFilmOfAnotherKind)
{
    Make("a.mkv", {});
    Make("b.mp4", {});
    EXPECT_EQ(Refusal({"a.mkv", "b.mp4"}, "c.mkv"), "b.mp4");
}

TEST_F(JoinErrors, NamePartOfAnotherCoding)
{
    Make("a.mkv", {});
    Make("b.mkv", {.quality = Quality::High});
    EXPECT_EQ(Refusal({"a.mkv", "b.mkv"}, "c.mkv"), "b.mkv");
}

TEST_F(JoinErrors, NameFileThatIsNoFilm)
{
    Make("a.mkv", {});
    WriteBytes(m_folder / "b.mkv", "no film");
    EXPECT_EQ(Refusal({"a.mkv", "b.mkv"}, "c.mkv"), "b.mkv");
}

TEST_F(JoinErrors, NameFilmOfKindThatCannotBeJoined)
{
    Make("a.nut", {});
    EXPECT_EQ(Refusal({"a.nut"}, "c.nut"), "c.nut");
}

TEST_F(JoinErrors, NameSequenceOfPictures)
{
    EXPECT_EQ(Refusal({"a-##.png"}, "c-##.png"), "c-##.png");
}

} // namespace
