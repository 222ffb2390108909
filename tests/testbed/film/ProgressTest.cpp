// SPDX-License-Identifier: MIT
#include <film/Progress.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::HasSubstr;
using testing::Not;

constexpr RecordingProgress kHalf{300, 600};

TEST(Progress, ShowsPercentRateAndTimeLeftInBar)
{
    EXPECT_EQ(ProgressBarText(kHalf, 3.0, 120),
              " 50% [####################....................] 300/600 frames, 100 fps, 0:03 left");
}

TEST(Progress, WritesFailureForOpenJobDescriptionInOneLine)
{
    EXPECT_EQ(FailOpenJdText("No.\nGive another."), "openjd_fail: No. Give another.");
}

TEST(Progress, FitsBarIntoEveryTerminal)
{
    for (int columns = 1; columns < 200; ++columns)
    {
        const std::string bar = ProgressBarText({599'999, 600'000}, 12'345.0, columns);
        EXPECT_LE(bar.size(), static_cast<std::size_t>(std::max(1, columns - 1))) << columns;
    }
}

TEST(Progress, ShowsNoTimeLeftBeforeFirstFrame)
{
    EXPECT_THAT(ProgressLineText({0, 600}, 0.0), HasSubstr("-:-- left"));
}

TEST(Progress, ExcludesKeptFramesFromRate)
{
    EXPECT_EQ(ProgressLineText({.framesDone = 300, .framesTotal = 600, .framesKept = 200}, 1.0),
              " 50%  300/600 frames, 100 fps, 0:03 left");
    EXPECT_EQ(ProgressLineText({.framesDone = 200, .framesTotal = 600, .framesKept = 200}, 0.01),
              " 33%  200/600 frames, 0 fps, -:-- left");
}

TEST(Progress, ShowsHundredPercentOnlyAtTheEnd)
{
    EXPECT_THAT(ProgressLineText({9999, 10000}, 1.0), HasSubstr(" 99%"));
    EXPECT_THAT(ProgressLineText({10000, 10000}, 1.0), HasSubstr("100%"));
}

TEST(Progress, ShowsHoursOfLongTimes)
{
    EXPECT_THAT(ProgressLineText({1, 3601}, 1.0), HasSubstr("1:00:00 left"));
}

TEST(Progress, WritesJsonAsOneObject)
{
    EXPECT_EQ(ProgressJsonText(kHalf, 1.5),
              R"({"event":"progress","frames":300,"total":600,"seconds":1.500})");
}

TEST(Progress, ReportsFileFramesSizeAndTime)
{
    const FilmReport report{"drop.mp4", 600, 600, 1280, 720, 60.0, 4.25, 1'234'567, {}};
    EXPECT_EQ(ReportText(report),
              "drop.mp4: 600 frames of 1280x720 at 60 fps, 1.2 MB, made in 4.2 s");
    const FilmReport single{"a.png", 1, 1, 320, 180, 60.0, 0.1, 1'000, {}};
    EXPECT_THAT(ReportText(single), HasSubstr("a.png: 1 frame of 320x180"));
    EXPECT_EQ(ReportJsonText(report),
              R"({"event":"done","file":"drop.mp4","frames":600,"width":1280,)"
              R"("height":720,"fps":60,"bytes":1234567,"seconds":4.250})");
}

TEST(Progress, ReportsStoredFramesOfVariableRate)
{
    FilmReport report{"drop.gif", 600, 600, 1280, 720, 60.0, 4.25, 1'234'567, 424};
    EXPECT_EQ(
        ReportText(report),
        "drop.gif: 600 frames of 1280x720 at 60 fps, 424 of them stored, 1.2 MB, made in 4.2 s");
    EXPECT_THAT(ReportJsonText(report), HasSubstr(R"("fps":60,"stored":424,"bytes")"));
    report.stored = 600;
    EXPECT_THAT(ReportText(report), Not(HasSubstr("stored")));
}

TEST(Progress, EscapesFileNameInJson)
{
    FilmReport report;
    report.file = "a\"b\\c\nd.mp4";
    EXPECT_THAT(ReportJsonText(report), HasSubstr(R"("file":"a\"b\\c\nd.mp4")"));
    EXPECT_THAT(ReportJsonText(report), Not(HasSubstr("\n")));
}

} // namespace
} // namespace boxreel
