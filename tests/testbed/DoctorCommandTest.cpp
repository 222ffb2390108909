// SPDX-License-Identifier: MIT
#include "SelfTest.h"
#include "Subprocess.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace boxreel
{
namespace
{

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST(SelfTest, EndsInTheSameStateOnEveryMachine)
{
    EXPECT_EQ(RunSelfTest(), kSelfTestState);
}

TEST(DoctorCommand, SaysOfEachThingThatItWorks)
{
    const TemporaryFolder folder;
    const Outcome outcome = RunBoxreel({"doctor"}, folder.Path());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_EQ(outcome.errors, "");
    for (const char* thing : {"engine", "mp4, H.264", "webm, VP9", "webm, AV1", "mkv, FFV1", "gif",
                              "apng", "webp", "png", "pdf", "disk", "display"})
    {
        EXPECT_THAT(outcome.output, HasSubstr("ok    " + std::string(thing)));
    }
    EXPECT_THAT(outcome.output, ContainsRegex("ok    (OSMesa|EGL)"));
    EXPECT_TRUE(folder.Files().empty());
}

TEST(DoctorCommand, SaysThatADisplayThatIsNamedIsNotThere)
{
    const TemporaryFolder folder;
    const Variable some("DISPLAY", ":4711");
    const Outcome outcome = RunBoxreel({"doctor"}, folder.Path());
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.output, HasSubstr(":4711"));
    EXPECT_THAT(outcome.output, HasSubstr("unset DISPLAY"));
}

/// Lets none of these libraries load in programs that are started: they find files that are none.
class Unloadable
{
public:
    explicit Unloadable(const std::vector<std::string>& libraries)
    {
        for (const std::string& library : libraries)
        {
            std::ofstream(m_folder / library) << "no library";
        }
    }

private:
    TemporaryFolder m_folder;
    Variable m_path{"LD_LIBRARY_PATH", m_folder.Path().string()};
};

TEST(DoctorCommand, CountsOneBackEndAsEnough)
{
    const TemporaryFolder folder;
    const std::pair<const char*, const char*> kLibraries[] = {{"libOSMesa.so.8", "OSMesa"},
                                                              {"libEGL.so.1", "EGL"}};
    for (const auto& [library, name] : kLibraries)
    {
        const Unloadable unloadable({library});
        const Outcome outcome = RunBoxreel({"doctor"}, folder.Path());
        if (outcome.code != 0)
        {
            continue; // where the other is not installed
        }
        EXPECT_THAT(outcome.output, ContainsRegex(std::string("\nnone  ") + name));
        EXPECT_THAT(outcome.output, Not(HasSubstr("FAIL")));
    }
}

TEST(DoctorCommand, FailsForBothBackEndsWhenNoneDraws)
{
    const TemporaryFolder folder;
    const Unloadable unloadable({"libOSMesa.so.8", "libEGL.so.1"});
    const Outcome outcome = RunBoxreel({"doctor"}, folder.Path());
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.output, HasSubstr("FAIL  OSMesa"));
    EXPECT_THAT(outcome.output, HasSubstr("FAIL  EGL"));
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
