// SPDX-License-Identifier: MIT
#include <film/StageReport.h>

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

namespace boxreel
{
namespace
{

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
    EXPECT_THAT(text, HasSubstr("\n  starting                  main         2.000     5.000"));
    EXPECT_THAT(text, HasSubstr("\n  simulating                main         2.000     2.100"));
    EXPECT_THAT(text, HasSubstr("\n  drawing                   raster       1.000\n"));
    EXPECT_THAT(text, HasSubstr("\n  waiting for the encoder   main         0.000     5.000"));
    EXPECT_THAT(text, HasSubstr("\n  encoding                  encoder      4.000     9.000"));
    EXPECT_THAT(text, HasSubstr("\n  encoding, and the rest    codec        3.000\n"))
        << "100 - 10 of the raster threads - 20 - 40 ms, of ten frames";
    EXPECT_THAT(text,
                testing::EndsWith("\n  all                                   12.000    35.000"));
}

TEST(StageReport, TellsProgramsTheSameInOneLine)
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
