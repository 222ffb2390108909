// SPDX-License-Identifier: MIT
#include "Subprocess.h"

#include <cli/SelfTest.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace boxreel
{
namespace
{

using testing::ContainsRegex;
using testing::HasSubstr;

TEST(SelfTest, EndsInTheSameStateOnEveryMachine)
{
    EXPECT_EQ(RunSelfTest(), kSelfTestState);
}

TEST(DoctorCommand, ReportsEachWorkingFeature)
{
    const TemporaryFolder folder;
    const Outcome outcome = RunBoxreel({"doctor"}, folder.Path());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_EQ(outcome.errors, "");
    for (const char* thing : {"engine", "mp4, H.264", "webm, VP9", "webm, AV1", "mkv, FFV1", "gif",
                              "apng", "webp", "png", "html", "pdf", "disk", "display"})
    {
        EXPECT_THAT(outcome.output, HasSubstr("ok    " + std::string(thing)));
    }
    EXPECT_THAT(outcome.output, ContainsRegex("ok    (OSMesa|EGL)"));
    EXPECT_TRUE(folder.Names().empty());
}

TEST(DoctorCommand, ReportsMissingDisplay)
{
    const TemporaryFolder folder;
    const Variable some("DISPLAY", ":4711");
    const Outcome outcome = RunBoxreel({"doctor"}, folder.Path());
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.output, HasSubstr(":4711"));
    EXPECT_THAT(outcome.output, HasSubstr("unset DISPLAY"));
}

TEST(DoctorCommand, TakesNoArguments)
{
    const TemporaryFolder folder;
    const Outcome outcome = RunBoxreel({"doctor", "me"}, folder.Path());
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
}

} // namespace
} // namespace boxreel
