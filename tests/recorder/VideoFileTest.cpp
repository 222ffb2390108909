// SPDX-License-Identifier: MIT
#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "ShownFrames.h"
#include "TestFilm.h"

#include <recorder/VideoWriter.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <string>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/// What lies in the folder while a film is written, after it, and when something goes wrong; and
/// which requests are refused before anything is written.
namespace
{

using namespace testfilm;
using boxreel::CheckVideoPath;
using boxreel::Error;
using boxreel::ErrorKind;
using boxreel::Frame;
using boxreel::IsError;
using boxreel::Quality;
using boxreel::Rational;
using boxreel::RefusesWith;
using boxreel::Result;
using boxreel::StoredFrameRate;
using boxreel::VideoSettings;
using boxreel::VideoWriter;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const VideoSettings kSmall{.width = 64, .height = 48, .framesPerSecond = {25, 1}};

class VideoFile : public testing::TestWithParam<const char*>
{
protected:
    VideoWriter Open(const std::string& name, const VideoSettings& settings = kSmall)
    {
        Result<VideoWriter> writer = VideoWriter::Open(m_folder / name, settings);
        EXPECT_TRUE(writer) << writer.GetError().Text();
        return std::move(*writer);
    }

    /// The Error of an Open that must fail, having written nothing.
    Error Refusal(const std::filesystem::path& path, const VideoSettings& settings = kSmall)
    {
        const std::vector<std::string> before = m_folder.Names();
        const Result<VideoWriter> writer = VideoWriter::Open(path, settings);
        EXPECT_FALSE(writer) << path;
        EXPECT_EQ(m_folder.Names(), before);
        return writer ? Error{} : writer.GetError();
    }

    TemporaryFolder m_folder;
};

TEST_P(VideoFile, HasItsNameOnlyAfterClose)
{
    const std::string extension = GetParam();
    {
        VideoWriter writer = Open("film" + extension);
        for (const Frame& frame : Drawings(64, 48, 30))
        {
            ASSERT_TRUE(writer.Append(frame));
            EXPECT_THAT(m_folder.Names(), ElementsAre("film.part" + extension));
        }
        ASSERT_TRUE(writer.Close());
        EXPECT_THAT(m_folder.Names(), ElementsAre("film" + extension));
    }
    EXPECT_THAT(m_folder.Names(), ElementsAre("film" + extension));
}

TEST_P(VideoFile, IsGoneWhenTheWriterIsDestroyedBeforeClose)
{
    {
        VideoWriter writer = Open(std::string("film") + GetParam());
        ASSERT_TRUE(writer.Append(Drawing(64, 48, 0)));
    }
    EXPECT_THAT(m_folder.Names(), IsEmpty());
}

TEST_P(VideoFile, IsNotOverwrittenUnlessAllowed)
{
    const std::filesystem::path path = m_folder / (std::string("film") + GetParam());
    WriteBytes(path, "precious");
    const Error error = Refusal(path);
    EXPECT_EQ(error.kind, ErrorKind::Unusable);
    EXPECT_THAT(error.Text(), AllOf(HasSubstr(path.string()), HasSubstr("overwrite = true")));
    EXPECT_EQ(ReadBytes(path), "precious");
    {
        VideoSettings settings = kSmall;
        settings.overwrite = true;
        VideoWriter writer = Open(path.filename().string(), settings);
        ASSERT_TRUE(writer.Append(Drawing(64, 48, 0)));
        EXPECT_EQ(ReadBytes(path), "precious")
            << "the old film stays until the new one is complete";
        ASSERT_TRUE(writer.Close());
    }
    EXPECT_EQ(ReadFilm(path).frames.size(), 1u);
}

TEST_P(VideoFile, HasTheSameBytesEveryTime)
{
    const std::string extension = GetParam();
    for (const Quality quality :
         {Quality::Draft, Quality::Standard, Quality::High, Quality::Lossless})
    {
        VideoSettings settings = kSmall;
        settings.quality = quality;
        settings.overwrite = true;
        WriteFilm(m_folder / ("a" + extension), settings, Drawings(160, 96, 40));
        WriteFilm(m_folder / ("b" + extension), settings, Drawings(160, 96, 40));
        const std::string bytes = ReadBytes(m_folder / ("a" + extension));
        EXPECT_EQ(bytes, ReadBytes(m_folder / ("b" + extension)));
        EXPECT_EQ(bytes.find("Lavf5"), std::string::npos)
            << "a version of a library is in the film";
        EXPECT_EQ(bytes.find("Lavc5"), std::string::npos)
            << "a version of a library is in the film";
    }
}

TEST_P(VideoFile, RepeatsThePreviousFrame)
{
    const std::string extension = GetParam();
    VideoSettings settings = kSmall;
    settings.quality = Quality::Lossless;
    VideoWriter writer = Open("film" + extension, settings);
    ASSERT_TRUE(writer.Append(Drawing(64, 48, 0)));
    ASSERT_TRUE(writer.Repeat());
    ASSERT_TRUE(writer.Append(Drawing(64, 48, 5)));
    ASSERT_TRUE(writer.Repeat());
    ASSERT_TRUE(writer.Repeat());
    ASSERT_TRUE(writer.Close());
    EXPECT_THAT(ReadShown(m_folder / ("film" + extension), settings.framesPerSecond),
                ElementsAre(Drawing(64, 48, 0), Drawing(64, 48, 0), Drawing(64, 48, 5),
                            Drawing(64, 48, 5), Drawing(64, 48, 5)));
}

TEST_P(VideoFile, AcceptsAnyName)
{
    for (const char* stem :
         {"with a space", "a:b", "http:x", "größe-日本", "100%d", "-o", "a.b", "#1"})
    {
        const std::filesystem::path path = m_folder / (std::string(stem) + GetParam());
        WriteFilm(path, kSmall, Drawings(64, 48, 3));
        EXPECT_EQ(ReadFilm(path).frames.size(), 3u) << path;
    }
}

INSTANTIATE_TEST_SUITE_P(EveryContainer, VideoFile,
                         testing::Values(".mp4", ".mkv", ".webm", ".gif", ".apng", ".webp"),
                         [](const testing::TestParamInfo<const char*>& test) {
                             return std::string(test.param + 1);
                         });

using VideoFileErrors = VideoFile;

TEST_F(VideoFileErrors, NamePathInMissingFolder)
{
    for (const auto& [name, file] :
         {std::pair("film.mp4", "film.mp4"), {"frames-####.png", "frames-0000.png"}})
    {
        EXPECT_THAT(Refusal(m_folder / "missing" / name),
                    IsError(ErrorKind::Unusable, (m_folder / "missing" / file).string()));
    }
}

TEST_F(VideoFileErrors, NameFolderWithoutPermission)
{
    // The kernel's folder refuses even the superuser.
    for (const char* name : {"film.mp4", "frames-##.png"})
    {
        const Error error = Refusal(std::filesystem::path("/proc/self/fd") / name);
        EXPECT_EQ(error.kind, ErrorKind::Unusable);
        EXPECT_THAT(error.Text(), HasSubstr("/proc/self/fd"));
    }
}

TEST_F(VideoFileErrors, RefuseSecondWriterOfAFilm)
{
    VideoWriter first = Open("film.mp4");
    const Error error = Refusal(m_folder / "film.mp4");
    EXPECT_EQ(error.kind, ErrorKind::Failed) << "a later attempt may find it free";
    ASSERT_TRUE(first.Append(Drawing(64, 48, 0)));
    ASSERT_TRUE(first.Close());
    EXPECT_EQ(ReadFilm(m_folder / "film.mp4").frames.size(), 1u);
}

TEST_F(VideoFileErrors, RefuseFilmWithoutFrames)
{
    {
        VideoWriter writer = Open("film.mp4");
        const Result<void> closed = writer.Close();
        ASSERT_FALSE(closed);
        EXPECT_EQ(closed.GetError().kind, ErrorKind::Unusable);
    }
    EXPECT_THAT(m_folder.Names(), IsEmpty());
}

/// Writes noise into `path` in a process whose files may not grow beyond 64 kB. Exit code: 0 when
/// it failed as it should, with the right Error; the sentence goes to `report`.
int WriteIntoALimit(const std::filesystem::path& path, const std::filesystem::path& report)
{
    const pid_t child = fork();
    if (child == 0)
    {
        signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{65536, 65536};
        setrlimit(RLIMIT_FSIZE, &limit);
        VideoSettings settings{.width = 256, .height = 256, .quality = Quality::Draft};
        Result<VideoWriter> writer = VideoWriter::Open(path, settings);
        Result<void> done = writer ? Result<void>() : Result<void>(writer.GetError());
        for (int i = 0; i < 100 && done; ++i)
        {
            done = writer->Append(Noise(256, 256, i));
        }
        done = done ? writer->Close() : done;
        WriteBytes(report, done ? "no error" : done.GetError().culprit);
        const bool isRight = !done && done.GetError().kind == ErrorKind::Failed;
        writer = Error{}; // destroys the writer; _exit would not
        _exit(isRight ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(VideoFileErrors, ReportFullDiskAndLeaveNothing)
{
    for (const char* name : {"film.mp4", "film.mkv", "film.webm", "film.gif", "frames-####.png"})
    {
        SCOPED_TRACE(name);
        TemporaryFolder reports;
        EXPECT_EQ(WriteIntoALimit(m_folder / name, reports / "report"), 0);
        EXPECT_THAT(ReadBytes(reports / "report"), testing::StartsWith((m_folder / "").string()));
        EXPECT_THAT(m_folder.Names(), IsEmpty());
    }
}

struct Refused
{
    const char* name;
    VideoSettings settings;
    const char* culprit;
    const char* detail; ///< a number or a name of problem or remedy
};

TEST(CheckVideoPath, RefusesSettingsThatFormatsDoNotSupport)
{
    const Refused cases[] = {
        {"film", {}, "film", ""},
        {"film.avi", {}, "film.avi", ".avi"},
        {"film.avi",
         {},
         "film.avi",
         ".mp4, .mkv, .webm, .gif, .apng, .webp, .y4m, .nut or a name like frames-####.png"},
        {"", {}, "''", ""},
        {"folder/", {}, "folder/", ""},
        {".mp4", {}, ".mp4", ""},
        {"frames.png", {}, "frames.png", "frames-####.png"},
        {"##########.png", {}, "##########.png", "nine #"},
        {"film.mp4",
         {.width = 1281, .height = 721},
         "width x height = 1281x721",
         "1282x722, chroma = Chroma::Full"},
        {"film.mkv", {.width = 1281, .height = 720}, "width x height = 1281x720", "1282x720"},
        {"film.mkv",
         {.width = 1281, .height = 720},
         "width x height = 1281x720",
         "quality = Quality::Lossless, .gif or frames-####.png"},
        {"film.y4m",
         {.width = 1281, .height = 720},
         "width x height = 1281x720",
         "1282x720, chroma = Chroma::Full or nut"},
        {"-",
         {.width = 1281, .height = 720, .format = "y4m"},
         "width x height = 1281x720",
         "1282x720, chroma = Chroma::Full or nut"},
        {"film.webm", {.width = 1280, .height = 721}, "width x height = 1280x721", "1280x722"},
        {"film.gif", {.width = 0, .height = 720}, "width x height = 0x720", ""},
        {"film.mp4", {.width = -2, .height = 720}, "width x height = -2x720", ""},
        {"film.mp4", {.width = 8194, .height = 720}, "width x height = 8194x720", "8192"},
        {"frames-#.png", {.width = 20, .height = 100000}, "width x height = 20x100000", "8192"},
        {"film.mp4", {.framesPerSecond = {1001, 1}}, "framesPerSecond = 1001/1", "1000"},
        {"film.mp4", {.framesPerSecond = {0, 1}}, "framesPerSecond = 0/1", ""},
        {"film.mp4", {.threads = 65}, "threads = 65", "64"},
        {"film.y4m",
         {.timing = boxreel::FrameTiming::Variable},
         "film.y4m",
         "timing = FrameTiming::Variable"},
        {"f-##.png",
         {.timing = boxreel::FrameTiming::Variable},
         "f-##.png",
         "timing = FrameTiming::Variable"},
        {"film.webp",
         {.timing = boxreel::FrameTiming::Constant},
         "film.webp",
         "timing = FrameTiming::Constant"},
        {"film.mp4", {.threads = -1}, "threads = -1", "64"},
        {"film.mp4", {.codec = "vp9"}, "codec = vp9", "av1"},
        {"film.gif", {.codec = "h264"}, "codec = h264", "film.gif"},
        {"film.gif", {.chroma = boxreel::Chroma::Full}, "chroma = Chroma::Full", "film.gif"},
        {"film.gif", {.codecOptions = {{"crf", "2"}}}, "codecOptions", "film.gif"},
        {"film.y4m", {.resume = true}, "film.y4m", "resume"},
        {"film.mp4", {.plays = 2}, "film.mp4", "plays"},
        {"-", {.format = "gif"}, "format = gif", "y4m"},
    };
    for (const Refused& c : cases)
    {
        EXPECT_THAT(CheckVideoPath(c.name, c.settings), RefusesWith(c.culprit, c.detail));
        EXPECT_FALSE(VideoWriter::Open(c.name, c.settings));
    }
}

TEST(CheckVideoPath, AcceptsFormatsInAnyCaseAndOddSizesIn444)
{
    for (const char* name :
         {"a.mp4", "a.MP4", "a.mkv", "a.WebM", "a.gif", "a-####.png", "#.PNG", "b/c-#-x.png"})
    {
        EXPECT_TRUE(CheckVideoPath(name, {})) << name;
    }
    VideoSettings odd{.width = 1281, .height = 721};
    EXPECT_TRUE(CheckVideoPath("a.gif", odd));
    EXPECT_TRUE(CheckVideoPath("a.apng", {.timing = boxreel::FrameTiming::Constant}));
    EXPECT_TRUE(CheckVideoPath("a-#.png", odd));
    EXPECT_TRUE(CheckVideoPath("a.nut", odd));
    odd.chroma = boxreel::Chroma::Full;
    EXPECT_TRUE(CheckVideoPath("a.y4m", odd));
    odd.chroma = boxreel::Chroma::Half;
    odd.quality = Quality::Lossless;
    EXPECT_TRUE(CheckVideoPath("a.mp4", odd));
    EXPECT_TRUE(CheckVideoPath("a.mkv", odd));
    EXPECT_TRUE(CheckVideoPath("a.webm", odd));
}

TEST_F(VideoFileErrors, DoNotOccurForOddAndTinySizes)
{
    for (const char* name : {"film.mp4", "film.mkv", "film.webm", "film.gif", "p-##.png"})
    {
        SCOPED_TRACE(name);
        const std::vector<Frame> frames = Drawings(61, 47, 5);
        WriteFilm(m_folder / name, {.framesPerSecond = {25, 1}, .quality = Quality::Lossless},
                  frames);
        EXPECT_EQ(ReadFilm(m_folder / name).frames, frames);
    }
    const std::vector<Frame> tiny(3, Drawing(64, 48, 0));
    for (const char* name : {"tiny.mp4", "tiny.mkv", "tiny.webm"})
    {
        SCOPED_TRACE(name);
        Frame frame(2, 2);
        FillRect(frame, 0, 0, 2, 2, kOutline);
        WriteFilm(m_folder / name, {.framesPerSecond = {25, 1}}, {frame, frame, frame});
        EXPECT_EQ(ReadFilm(m_folder / name).frames.size(), 3u);
    }
    for (int k = 0; k < 5 * 5; ++k)
    {
        const int width = 1 + k % 5;
        const int height = 1 + k / 5;
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        const std::vector<Frame> frames{Noise(width, height, 0), Noise(width, height, 1)};
        WriteFilm(m_folder / "film.mkv",
                  {.framesPerSecond = {25, 1}, .quality = Quality::Lossless, .overwrite = true},
                  frames);
        EXPECT_EQ(ReadFilm(m_folder / "film.mkv").frames, frames);
    }
}

TEST(StoredFrameRate, EqualsGivenRateExceptForFastGif)
{
    EXPECT_EQ(StoredFrameRate("a.mp4", {60, 1}), (Rational{60, 1}));
    EXPECT_EQ(StoredFrameRate("a.gif", {50, 1}), (Rational{50, 1}));
    EXPECT_EQ(StoredFrameRate("a.gif", {60, 1}), (Rational{30, 1}));
    EXPECT_EQ(StoredFrameRate("a.gif", {120, 1}), (Rational{40, 1}));
    EXPECT_EQ(StoredFrameRate("a.gif", {2997, 100}), (Rational{2997, 100}));
}

} // namespace
