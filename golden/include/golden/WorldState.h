// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// A world's state as plain numbers, how it went there step by step, and how two of them differ in
/// words. Knows no engine: <golden/StateHash.h> reads them from a world.
namespace boxreel
{

/// A body of it. The numbers are those that the engine's getters give.
struct BodyState
{
    int number = 0;            ///< its place in the order of creation, as `--labels` shows it
    float x = 0;               ///< of the origin, to the right [m]
    float y = 0;               ///< of the origin, upwards [m]
    float angle = 0;           ///< anticlockwise from the x axis [rad]
    float velocityX = 0;       ///< of the centre of mass, to the right [m/s]
    float velocityY = 0;       ///< of the centre of mass, upwards [m/s]
    float angularVelocity = 0; ///< anticlockwise [rad/s]
    friend bool operator==(const BodyState&, const BodyState&) = default; ///< -0 equals 0
};

/// All bodies, the oldest first.
struct WorldState
{
    std::vector<BodyState> bodies; ///< in the order of their creation
};

/// A line a body: number, x, y, angle and, unless they are all 0, the velocities. The shortest
/// numbers that read back to the same bits.
std::string ToText(const WorldState& state);

/// What ToText wrote; Unusable with the line that is not of this kind.
Result<WorldState> ParseWorldState(std::string_view text);

/// "3 of 55 bodies differ, most of all body 17: 0.031 m lower (y 1.02 instead of 1.051)"; empty
/// when all are equal.
std::string DescribeDifference(const WorldState& expected, const WorldState& actual);

/// A step's state in few characters.
struct TraceStep
{
    std::int64_t step = 0; ///< since the start
    std::string world;     ///< 8 hex digits of the whole state's hash
    /// A hex digit of each body's hash, by number, '.' where there is none any more. Where more
    /// than 256 bodies have been made: digits of rows and of columns of them, see kLongestTrace.
    std::string bodies;
    /// True if all members are equal.
    friend bool operator==(const TraceStep&, const TraceStep&) = default;
};

/// The steps that a world went through, in order.
struct StateTrace
{
    std::vector<TraceStep> steps; ///< in their order
};

/// Up to so many bodies each has a digit of its own. More are thought of as a square, numbered row
/// by row, and each row and each column has a digit, the rows' before a slash, the columns' behind
/// it: a single body that differs is found where its row and its column cross.
inline constexpr int kLongestTrace = 256;

/// A line a step.
std::string ToText(const StateTrace& trace);
/// What ToText wrote, or an Error that names the line.
Result<StateTrace> ParseStateTrace(std::string_view text);

/// Where two ways part.
struct TraceDifference
{
    std::int64_t step = 0;   ///< the first that differs
    std::vector<int> bodies; ///< those that may differ there, by number; empty: not to be told
    bool isOfOne = false;    ///< only one of the traces has that step
    bool isFirst = false;    ///< no step before it was compared, so they may have parted earlier
};

/// None when both have the same steps and each is the same. A digit may be the same by chance (one
/// in 16) where a body differs; the step is never in doubt, unless it is the first of the traces.
std::optional<TraceDifference> FirstDifference(const StateTrace& expected,
                                               const StateTrace& actual);

/// "from step 43 on, body 17 first", or "at step 121, if not before, body 17".
std::string Describe(const TraceDifference& difference);

} // namespace boxreel
