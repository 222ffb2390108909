// SPDX-License-Identifier: MIT
#include "../../base/TemporaryFolder.h"

#include <base/AtomicFile.h>
#include <options/OptionNames.h>
#include <recorder/VideoWriter.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

std::string CulpritOf(const char* film, const VideoSettings& settings)
{
    const Result<void> checked = CheckVideoPath(film, settings);
    EXPECT_FALSE(checked) << film;
    EXPECT_EQ(checked.GetError().kind, ErrorKind::Unusable);
    return checked.GetError().culprit.Text(OptionNames());
}

TEST(OptionNames, NameTheCulpritsOfFilms)
{
    EXPECT_EQ(CulpritOf("a.mp4", {.width = 3, .height = 4}), "--size 3x4");
    EXPECT_EQ(CulpritOf("a.mp4", {.framesPerSecond = {0, 1}}), "--fps 0/1");
    EXPECT_EQ(CulpritOf("a.gif", {.codec = "h264"}), "--codec h264");
    EXPECT_EQ(CulpritOf("a.gif", {.chroma = Chroma::Full}), "--chroma 444");
    EXPECT_EQ(CulpritOf("a.y4m", {.quality = Quality::Lossless}), "--quality lossless");
    EXPECT_EQ(CulpritOf("a.gif", {.codecOptions = {{"crf", "2"}}}), "--codec-option");
    EXPECT_EQ(CulpritOf("-", {.format = "gif"}), "--format gif");
    EXPECT_EQ(CulpritOf("a.gif", {.plays = -1}), "--loop -1");
    EXPECT_EQ(CulpritOf("a.mp4", {.threads = 65}), "--threads 65");
    EXPECT_EQ(CulpritOf("a.mp4", {.groupFrames = -1}), "--group -1");
}

TEST(OptionNames, NameTheRemediesOfFilms)
{
    const std::pair<VideoSettings, const char*> cases[] = {
        {{.timing = FrameTiming::Variable}, "--variable-rate"}, {{.resume = true}, "--resume"}};
    for (const auto& [settings, option] : cases)
    {
        const Result<void> checked = CheckVideoPath("a.y4m", settings);
        ASSERT_FALSE(checked) << option;
        EXPECT_THAT(TextInOptions(checked.GetError()), testing::HasSubstr(option));
    }
}

TEST(OptionNames, NameForceWhereAFileExists)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(WriteWhole(folder / "a.txt", "a", false));
    const Result<void> again = WriteWhole(folder / "a.txt", "b", false);
    ASSERT_FALSE(again);
    EXPECT_THAT(TextInOptions(again.GetError()), testing::HasSubstr("--force"));
}

} // namespace
} // namespace boxreel
