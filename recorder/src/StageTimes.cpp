// SPDX-License-Identifier: MIT
#include <recorder/StageTimes.h>

#include <ctime>

namespace boxreel
{

namespace
{

std::int64_t Now(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

} // namespace

void StageTimes::Add(Stage stage, std::int64_t cpuNanoseconds, std::int64_t wallNanoseconds)
{
    Sum& sum = m_sums[std::size_t(stage)];
    sum.cpu.fetch_add(cpuNanoseconds, std::memory_order_relaxed);
    sum.wall.fetch_add(wallNanoseconds, std::memory_order_relaxed);
}

StageTime StageTimes::At(Stage stage) const
{
    const Sum& sum = m_sums[std::size_t(stage)];
    return {1e-9 * double(sum.cpu.load(std::memory_order_relaxed)),
            1e-9 * double(sum.wall.load(std::memory_order_relaxed))};
}

StageTimer::StageTimer(StageTimes* times, Stage stage) : m_times(times), m_stage(stage)
{
    if (m_times != nullptr)
    {
        m_cpu = Now(CLOCK_THREAD_CPUTIME_ID);
        m_wall = Now(CLOCK_MONOTONIC);
    }
}

StageTimer::~StageTimer()
{
    if (m_times != nullptr)
    {
        m_times->Add(m_stage, Now(CLOCK_THREAD_CPUTIME_ID) - m_cpu, Now(CLOCK_MONOTONIC) - m_wall);
    }
}

} // namespace boxreel
