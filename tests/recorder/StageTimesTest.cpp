// SPDX-License-Identifier: MIT
#include <recorder/StageTimes.h>

#include <gtest/gtest.h>

#include <thread>

namespace boxreel
{
namespace
{

TEST(StageTimes, AddUpTimesOfSeveralThreads)
{
    StageTimes times;
    times.Add(Stage::Encode, 1'000'000, 2'000'000);
    std::thread([&times] { times.Add(Stage::Encode, 500'000'000, 1'000'000'000); }).join();
    times.Add(Stage::Write, 7'000'000, 7'000'000);
    EXPECT_DOUBLE_EQ(times.At(Stage::Encode).cpu, 0.501);
    EXPECT_DOUBLE_EQ(times.At(Stage::Encode).wall, 1.002);
    EXPECT_DOUBLE_EQ(times.At(Stage::Write).cpu, 0.007);
    EXPECT_EQ(times.At(Stage::Draw).cpu, 0.0);
}

TEST(StageTimes, DistinguishWaitingFromWork)
{
    StageTimes times;
    {
        const StageTimer timer(&times, Stage::WaitForFrame);
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    EXPECT_GE(times.At(Stage::WaitForFrame).wall, 0.03);
    EXPECT_LT(times.At(Stage::WaitForFrame).cpu, 0.03);
    {
        const StageTimer timer(&times, Stage::Draw);
        volatile double sum = 0.0;
        for (int i = 0; i < 1'000'000; ++i)
        {
            sum = sum + 1.0;
        }
    }
    EXPECT_GT(times.At(Stage::Draw).cpu, 0.0);
    EXPECT_EQ(times.At(Stage::Collect).wall, 0.0);
}

TEST(StageTimes, IgnoreTimerWithoutTimes)
{
    const StageTimer timer(nullptr, Stage::Draw);
}

} // namespace
} // namespace boxreel
