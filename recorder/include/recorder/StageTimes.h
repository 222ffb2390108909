// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

/// @file
/// Where the time of a film goes: each stage adds up what it takes on the thread that does it. A
/// timer without a StageTimes looks at no clock, so a film that nobody asks about pays nothing.
namespace boxreel
{

/// What time is spent on.
enum class Stage
{
    Simulate, ///< the caller's: its world is advanced
    Collect,  ///< the caller's: its world becomes a list
    Draw,
    Read,           ///< the pixels that have changed, out of the renderer
    Copy,           ///< them, into the queue in front of the writer
    WaitForEncoder, ///< the queue is full, or the film nearly done
    WaitForFrame,   ///< the queue is empty
    Convert,        ///< to the codec's colours
    Encode,         ///< but for threads of the codec's own
    Write,          ///< container and file
};
/// How many stages there are.
inline constexpr std::size_t kStageCount = 10;

/// What a stage has taken.
struct StageTime
{
    double cpu = 0.0;  ///< of the threads that did it [s]
    double wall = 0.0; ///< the sum over these threads [s]
};

/// Of one film; any thread may add.
class StageTimes
{
public:
    /// Adds to what a stage has taken [ns]; from any thread.
    void Add(Stage stage, std::int64_t cpuNanoseconds, std::int64_t wallNanoseconds);
    /// What a stage has taken so far.
    StageTime At(Stage stage) const;

private:
    struct Sum
    {
        std::atomic<std::int64_t> cpu{0};  // [ns]
        std::atomic<std::int64_t> wall{0}; // [ns]
    };
    std::array<Sum, kStageCount> m_sums;
};

/// Times what its thread does while it lives. Timers of one thread must not lie in each other, or
/// the inner one's time would count twice.
class StageTimer
{
public:
    /// Null: nothing is timed.
    StageTimer(StageTimes* times, Stage stage);
    ~StageTimer();
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

private:
    StageTimes* m_times;
    Stage m_stage;
    std::int64_t m_cpu = 0;  // when it began [ns]
    std::int64_t m_wall = 0; // when it began [ns]
};

} // namespace boxreel
