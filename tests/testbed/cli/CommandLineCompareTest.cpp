// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"
#include "ParseLine.h"

#include <gmock/gmock.h>

#include <optional>

namespace boxreel
{
namespace
{

CompareSettings DiffSettings(const std::string& options)
{
    const Result<Request> request = Parse("diff a.png b.png " + options);
    if (!request)
    {
        ADD_FAILURE() << options << ": " << request.GetError().Text();
        return {};
    }
    return Effective(std::get<DiffOptions>(*request).compare);
}

TEST(CommandLineCompare, UsesSameMachinePresetByDefault)
{
    const CompareSettings settings = DiffSettings("");
    EXPECT_EQ(settings.preset, "same-machine");
    EXPECT_EQ(settings.tolerance, CompareSettings::SameMachine().tolerance);
    EXPECT_EQ(DiffSettings("--preset cross-machine").edgeShift,
              CompareSettings::CrossMachine().edgeShift);
}

TEST(CommandLineCompare, AdaptsToARendererUnlessLimitsAreGiven)
{
    EXPECT_TRUE(DiffSettings("").adaptsToRenderer);
    EXPECT_TRUE(DiffSettings("--ignore 1,2,3x4").adaptsToRenderer);
    const std::optional<CompareSettings> other = ForOtherRenderer(DiffSettings("--ignore 1,2,3x4"));
    ASSERT_TRUE(other);
    EXPECT_EQ(other->preset, "cross-machine");
    EXPECT_THAT(other->options, testing::ElementsAre("--ignore"));
    for (const char* options : {"--preset same-machine", "--preset cross-machine", "--preset exact",
                                "--tolerance 0.00025", "--window 16"})
    {
        EXPECT_FALSE(ForOtherRenderer(DiffSettings(options))) << options;
    }
}

TEST(CommandLineCompare, ReplacesEveryLimitOfPreset)
{
    const CompareSettings settings =
        DiffSettings("--tolerance 0.5 --edge-shift 0.25 --max-pixels 7 --max-ratio 0.2% "
                     "--max-in-window 3 --window 9 --ignore 1,2,3x4 --ignore 10,20,30x40");
    EXPECT_EQ(settings.tolerance, 0.5);
    EXPECT_EQ(settings.edgeShift, 0.25);
    EXPECT_EQ(settings.maxPixels, 7);
    EXPECT_DOUBLE_EQ(settings.maxRatio, 0.002);
    EXPECT_EQ(settings.maxInWindow, 3);
    EXPECT_EQ(settings.densityWindow, 9);
    EXPECT_EQ(settings.ignored, (std::vector<PixelBounds>{{1, 2, 4, 6}, {10, 20, 40, 60}}));
    EXPECT_EQ(settings.preset, "same-machine");
    EXPECT_THAT(settings.options,
                testing::ElementsAre("--tolerance", "--edge-shift", "--max-pixels", "--max-ratio",
                                     "--max-in-window", "--window", "--ignore"));
    EXPECT_EQ(DiffSettings("--max-ratio 0.25").maxRatio, 0.25);
}

TEST(CommandLineCompare, ReplacesLimitBeforeAndAfterPreset)
{
    for (const char* options :
         {"--max-in-window 3 --preset exact", "--preset exact --max-in-window 3"})
    {
        const CompareSettings settings = DiffSettings(options);
        EXPECT_EQ(settings.maxInWindow, 3);
        EXPECT_EQ(settings.maxPixels, 0);
        EXPECT_EQ(settings.preset, "exact");
        EXPECT_THAT(settings.options, testing::ElementsAre("--max-in-window"));
    }
}

TEST(CommandLineCompare, GivesGoldenVerifyAllOptionsAndAcceptNone)
{
    const Result<Request> request =
        Parse("golden verify pyramid --preset cross-machine --max-pixels 5 --ignore 0,0,5x6");
    ASSERT_TRUE(request) << request.GetError().Text();
    const CompareSettings settings = Effective(std::get<GoldenOptions>(*request).compare);
    EXPECT_EQ(settings.preset, "cross-machine");
    EXPECT_THAT(settings.options, testing::ElementsAre("--max-pixels", "--ignore"));
    EXPECT_EQ(settings.maxPixels, 5);
    EXPECT_FALSE(Parse("golden accept pyramid --preset exact"));
}

TEST(CommandLineCompare, RefusesInvalidLimits)
{
    const auto refusal = [](const std::string& options) {
        const Result<Request> request = Parse("diff a.png b.png " + options);
        return request ? "accepted: " + options : request.GetError().culprit.Text();
    };
    for (const char* text : {"1,2,3", "1,2,0x4", "1,2,3x0", "-1,2,3x4", "1,2,3x4x5", "1,2,3x4,5",
                             "a,2,3x4", "1,2,65536x4", "x"})
    {
        EXPECT_EQ(refusal("--ignore " + std::string(text)), "--ignore " + std::string(text));
    }
    for (const char* text : {"200%", "1.5", "-1%", "%", "some"})
    {
        EXPECT_EQ(refusal("--max-ratio " + std::string(text)), "--max-ratio " + std::string(text));
    }
    for (const char* options :
         {"--tolerance 2", "--tolerance nan", "--edge-shift 0.5", "--max-pixels -1", "--window 0"})
    {
        EXPECT_EQ(refusal(options), options);
    }
    EXPECT_THAT(Parse("diff a.png b.png --preset cros-machine"),
                RefusesWith("--preset cros-machine", "'cross-machine'"));
}

} // namespace
} // namespace boxreel
