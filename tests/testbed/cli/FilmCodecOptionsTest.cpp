// SPDX-License-Identifier: MIT
#include "FilmFixture.h"
#include "Refusals.h"

#include <gmock/gmock.h>

#include <utility>

namespace boxreel
{
namespace
{

using testing::HasSubstr;
using testing::IsEmpty;

using FilmCodecOptions = FilmFixture;

TEST_F(FilmCodecOptions, NamesUnknownOptionAndWritesNothing)
{
    const Outcome outcome =
        Run({"record", "pyramid", "-o", "a.mkv", "--codec-option", "colour=blue"});
    ExpectRefused(outcome, "--codec-option colour");
    EXPECT_THAT(folder.Names(), IsEmpty());
}

TEST_F(FilmCodecOptions, RefusesValuesThatOtherOptionsDecide)
{
    const std::pair<const char*, const char*> options[] = {
        {"video_size=50x50", "size"},      {"video_size=640x360", "size"},
        {"time_base=1/7", "times"},        {"color_range=pc", "colours"},
        {"colorspace=bt470bg", "colours"}, {"flags=-global_header", "header"},
        {"flags=+pass1", "one pass"}};
    for (const char* name : {"a.mp4", "a.webm", "a.mkv"})
    {
        for (const auto& [option, what] : options)
        {
            const Outcome outcome = Run({"record", "pyramid", "-o", name, "--frames", "3", "--size",
                                         "320x180", "--codec-option", option});
            SCOPED_TRACE(name);
            ExpectRefused(outcome, std::string("--codec-option ") + option);
            EXPECT_THAT(outcome.errors, HasSubstr(what)) << name << ' ' << option;
        }
    }
    EXPECT_THAT(folder.Names(), IsEmpty());
}

TEST_F(FilmCodecOptions, RefusesOptionsUnknownToX264InAnyList)
{
    for (const char* option : {"x264-params=bogus=1", "x264opts=bogus=1"})
    {
        const Outcome outcome = Run({"record", "pyramid", "-o", "a.mkv", "--codec-option", option});
        ExpectRefused(outcome, std::string("--codec-option ") + option);
    }
    EXPECT_EQ(Run({"record", "pyramid", "-o", "a.mkv", "--frames", "3", "--size", "64x36",
                   "--codec-option", "x264-params=ref=2:keyint=5"})
                  .code,
              0);
}

TEST_F(FilmCodecOptions, RefusesRateOptionsWithLossless)
{
    const Outcome outcome = Run(
        {"record", "pyramid", "-o", "a.mp4", "--quality", "lossless", "--codec-option", "crf=20"});
    ExpectRefused(outcome, "--codec-option crf");
    EXPECT_THAT(folder.Names(), IsEmpty());
}

TEST_F(FilmCodecOptions, IsLosslessInEveryLosslessCodec)
{
    const auto record = [&](const std::string& name, const std::string& codec) {
        EXPECT_EQ(Run({"record", "dominos", "-o", name, "--codec", codec, "--quality", "lossless",
                       "--frames", "20", "--size", "320x180", "--constant-rate"})
                      .code,
                  0)
            << codec;
        return Decode(name);
    };
    const auto truth = record("ffv1.mkv", "ffv1");
    ASSERT_EQ(truth.size(), 20u);
    EXPECT_TRUE(record("av1.mkv", "av1") == truth);
    EXPECT_TRUE(record("vp9.mkv", "vp9") == truth);
    EXPECT_TRUE(record("h264.mkv", "h264") == truth);
}

} // namespace
} // namespace boxreel
