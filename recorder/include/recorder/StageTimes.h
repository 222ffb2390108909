// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

/// @file
/// Times the stages of a recording. Each stage adds the time on its own thread. A timer without a
/// StageTimes does not read the clock, so there is no cost when timing is off.
namespace boxreel
{

/// A stage of a recording.
enum class Stage
{
    Simulate, ///< the caller advances its world
    Collect,  ///< the caller converts its world to a list
    Draw,
    Read,           ///< changed pixels from the renderer
    Copy,           ///< changed pixels into the queue before the writer
    WaitForEncoder, ///< the queue is full, or the film is ending
    WaitForFrame,   ///< the queue is empty
    Convert,        ///< to the colour format of the codec
    Encode,         ///< without the codec's own threads
    Write,          ///< container and file
};
/// Number of stages.
inline constexpr std::size_t kStageCount = 10;

/// The time of a stage.
struct StageTime
{
    double cpu = 0.0;  ///< CPU time of its threads [s]
    double wall = 0.0; ///< elapsed time, summed over its threads [s]
};

/// The stage times of one film. Thread-safe.
class StageTimes
{
public:
    /// Adds to the time of a stage [ns]; thread-safe.
    void Add(Stage stage, std::int64_t cpuNanoseconds, std::int64_t wallNanoseconds);
    /// Returns the time of a stage so far.
    StageTime At(Stage stage) const;

private:
    struct Sum
    {
        std::atomic<std::int64_t> cpu{0};  // [ns]
        std::atomic<std::int64_t> wall{0}; // [ns]
    };
    std::array<Sum, kStageCount> m_sums;
};

/// Times its own lifetime on its thread. Timers of one thread must not be nested, because the inner
/// time would count twice.
class StageTimer
{
public:
    /// Starts timing; null: does nothing.
    StageTimer(StageTimes* times, Stage stage);
    ~StageTimer();
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

private:
    StageTimes* m_times;
    Stage m_stage;
    std::int64_t m_cpu = 0;  // start [ns]
    std::int64_t m_wall = 0; // start [ns]
};

} // namespace boxreel
