// SPDX-License-Identifier: MIT
#include "../StatsRows.h"

#include <film/StageReport.h>

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

/// A film of ten frames that took 100 ms of CPU time after a start of 20.
constexpr FilmTimes kTen{.frames = 10, .before = {0.02, 0.05}, .end = {0.12, 0.35}, .raster = 0.01};

TEST(StageReport, ShowsTimePerStageAndTheRemainder)
{
    StageTimes stages;
    stages.Add(Stage::Simulate, 20'000'000, 21'000'000);
    stages.Add(Stage::WaitForEncoder, 0, 50'000'000);
    stages.Add(Stage::Encode, 40'000'000, 90'000'000);
    const std::string text = DescribeStages(stages, kTen);
    // CPU and wall, in milliseconds a frame.
    EXPECT_THAT(NumbersOf(text, "starting"), ElementsAre(2.0, 5.0));
    EXPECT_THAT(NumbersOf(text, "simulating"), ElementsAre(2.0, 2.1));
    EXPECT_THAT(NumbersOf(text, "waiting for the encoder"), ElementsAre(0.0, 5.0));
    EXPECT_THAT(NumbersOf(text, "encoding"), ElementsAre(4.0, 9.0));
    EXPECT_THAT(NumbersOf(text, "encoding, and the rest"), ElementsAre(3.0))
        << "100 - 10 of the raster threads - 20 - 40 ms, of ten frames";
    EXPECT_THAT(NumbersOf(text, "all"), ElementsAre(12.0, 35.0));
}

TEST(StageReport, WritesStagesAsJsonInOneLine)
{
    StageTimes stages;
    stages.Add(Stage::Write, 5'000'000, 6'000'000);
    const std::string text = StageJson(stages, kTen);
    EXPECT_THAT(text, testing::StartsWith("{\"event\":\"stages\",\"frames\":10,\"stages\":["));
    EXPECT_THAT(text, HasSubstr("{\"stage\":\"writing\",\"thread\":\"encoder\",\"cpuSeconds\":"
                                "0.005000,\"wallSeconds\":0.006000}"));
    EXPECT_THAT(text, HasSubstr("{\"stage\":\"drawing\",\"thread\":\"raster\",\"cpuSeconds\":"
                                "0.010000}"));
    EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(StageReport, ContainsNoNanWithoutFrames)
{
    EXPECT_THAT(DescribeStages(StageTimes(), {}), testing::Not(HasSubstr("nan")));
    EXPECT_THAT(DescribeStages(StageTimes(), {}), testing::Not(HasSubstr("inf")));
}

TEST(StageReport, MeasuresAgeOfThisProcess)
{
    const ProcessTime before = ProcessSoFar();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const ProcessTime after = ProcessSoFar();
    EXPECT_GE(before.wall, 0.0);
    EXPECT_GT(before.cpu, 0.0);
    EXPECT_GE(after.wall, before.wall + 0.02);
    EXPECT_GE(after.cpu, before.cpu);
    EXPECT_GE(RasterSeconds(), 0.0);
}

} // namespace
} // namespace boxreel
