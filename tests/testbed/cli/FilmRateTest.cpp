// SPDX-License-Identifier: MIT
// The frame rate of films, which frames are stored, and what is reported of them.
#include "FilmFixture.h"

#include <render/Png.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::HasSubstr;

class FilmRate : public FilmFixture
{};

TEST_F(FilmRate, IsReportedForFastGif)
{
    const Outcome outcome =
        Run({"record", "pyramid", "-o", "film.gif", "--frames", "5", "--size", "160x90"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(Decode("film.gif", Frames::Stored).size(), 3u);
    EXPECT_THAT(outcome.errors, HasSubstr("film.gif: 3 frames of 160x90 at 30 fps (kept of 5: a "
                                          "GIF shows at most 50 a second)"));
}

TEST_F(FilmRate, IsConstantWithoutVariableRate)
{
    const auto make = [&](const std::vector<std::string>& more) {
        std::vector<std::string> command{"record", "pyramid", "--frames",   "40",   "--from", "8s",
                                         "--size", "160x90",  "--progress", "json", "--force"};
        command.insert(command.end(), more.begin(), more.end());
        return Run(command);
    };
    for (const std::string film : {"film.mp4", "film.mkv", "film.webm"})
    {
        SCOPED_TRACE(film);
        const Outcome constant = make({"-o", film});
        EXPECT_THAT(constant.errors, HasSubstr("\"frames\":40,"));
        EXPECT_EQ(Decode(film, Frames::Stored).size(), 40u);
        const Outcome variable = make({"-o", film, "--variable-rate"});
        const std::size_t stored = Decode(film, Frames::Stored).size();
        EXPECT_LT(stored, 5u);
        EXPECT_THAT(variable.errors, HasSubstr("\"stored\":" + std::to_string(stored)));
    }
    EXPECT_EQ(make({"-o", "film.mp4", "--variable-rate", "--constant-rate"}).code, 1);
}

TEST_F(FilmRate, IsReportedWithStoredFramesOfVariableFilms)
{
    for (const std::string film : {"film.gif", "film.apng", "film.webp"})
    {
        SCOPED_TRACE(film);
        const Outcome outcome = Run({"record", "pyramid", "--frames", "40", "--from", "8s", "--fps",
                                     "50", "--size", "160x90", "-o", film});
        ASSERT_EQ(outcome.code, 0) << outcome.errors;
        const std::size_t stored = Decode(film, Frames::Stored).size();
        EXPECT_LT(stored, 5u);
        EXPECT_THAT(outcome.errors, HasSubstr("40 frames of 160x90 at 50 fps, " +
                                              std::to_string(stored) + " of them stored"));
    }
}

TEST_F(FilmRate, IsReportedWithStoredFramesOfMergedFilms)
{
    const auto part = [&](const std::string& name, const std::string& range,
                          const std::vector<std::string>& more) {
        std::vector<std::string> command{"record",  "pyramid",       "--frames", "200", "--from",
                                         "7s",      "--size",        "160x90",   "-o",  name,
                                         "--force", "--frame-range", range};
        command.insert(command.end(), more.begin(), more.end());
        EXPECT_EQ(Run(command).code, 0);
    };
    const auto merge = [&](const std::vector<std::string>& more) {
        part("a.mkv", "0-99", more);
        part("b.mkv", "100-199", more);
        return Run({"merge", "a.mkv", "b.mkv", "-o", "film.mkv", "--force"}).errors;
    };
    const std::string variable = merge({"--variable-rate"});
    const std::size_t stored = Decode("film.mkv", Frames::Stored).size();
    EXPECT_LT(stored, 150u);
    EXPECT_THAT(variable, HasSubstr("200 frames of 2 parts, " + std::to_string(stored) +
                                    " of the frames stored"));
    EXPECT_THAT(merge({}), HasSubstr("200 frames of 2 parts\n"));
}

// The pyramid comes to rest within the film: a program that takes the k-th stored frame must get
// the moment k / 60 s.
TEST_F(FilmRate, PutsEachStoredFrameAtItsTime)
{
    ASSERT_EQ(Run({"record", "pyramid", "--quality", "lossless", "--frames", "120", "--from", "6s",
                   "--size", "160x90", "-o", "film.mp4"})
                  .code,
              0);
    const std::vector<Frame> frames = Decode("film.mp4", Frames::Stored);
    ASSERT_EQ(frames.size(), 120u);
    for (const int k : {0, 1, 59, 60, 100, 119})
    {
        ASSERT_EQ(Run({"shot", "pyramid", "--step", std::to_string(360 + k), "--size", "160x90",
                       "-o", "shot.png", "--force"})
                      .code,
                  0);
        const Result<Frame> shot = ReadPng(folder / "shot.png");
        EXPECT_TRUE(shot && *shot == frames[std::size_t(k)]) << k;
    }
}

} // namespace
} // namespace boxreel
