// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// A world's state as plain numbers, its trace step by step, and the difference of two of them.
/// Independent of an engine: <golden/StateHash.h> reads them from a world.
namespace boxreel
{

/// The state of a body, as returned by the engine's getters.
struct BodyState
{
    int number = 0;            ///< creation order, as shown by `--labels`
    float x = 0;               ///< x coordinate of the origin [m]
    float y = 0;               ///< y coordinate of the origin [m]
    float angle = 0;           ///< counter-clockwise from the x axis [rad]
    float velocityX = 0;       ///< x velocity of the centre of mass [m/s]
    float velocityY = 0;       ///< y velocity of the centre of mass [m/s]
    float angularVelocity = 0; ///< counter-clockwise [rad/s]
    friend bool operator==(const BodyState&, const BodyState&) = default; ///< -0 equals 0
};

/// All bodies, oldest first.
struct WorldState
{
    std::vector<BodyState> bodies; ///< in creation order
};

/// Returns one line per body: number, x, y, angle and, unless all are 0, the velocities. The
/// shortest numbers that read back exactly.
std::string ToText(const WorldState& state);

/// Parses the result of ToText. An Error (Unusable) contains the invalid line.
Result<WorldState> ParseWorldState(std::string_view text);

/// The difference of the bodies of two states.
struct StateDifference
{
    std::vector<int> missing;  ///< numbers of bodies that only the expected state has
    std::vector<int> extra;    ///< numbers of bodies that only the actual state has
    std::size_t compared = 0;  ///< bodies that both have …
    std::size_t different = 0; ///< … and those of them that differ
    BodyState expected;        ///< of the one whose place differs most, where any differs
    BodyState actual;          ///< of the same body
};

/// Compares body by body.
StateDifference DifferenceOf(const WorldState& expected, const WorldState& actual);

/// "3 of 55 bodies differ, most of all body 17: 0.031 m lower (y 1.02 instead of 1.051)"; empty
/// when all are equal.
std::string Describe(const StateDifference& difference);

/// A compact hash of a step's state.
struct TraceStep
{
    std::int64_t step = 0; ///< since the start
    std::string world;     ///< 8 hex digits of the whole state's hash
    /// A hex digit of each body's hash, by number, '.' for destroyed bodies. For more than 256
    /// bodies: digits of rows and columns, see kLongestTrace.
    std::string bodies;
    /// True if all members are equal.
    friend bool operator==(const TraceStep&, const TraceStep&) = default;
};

/// The steps of a world, in order.
struct StateTrace
{
    std::vector<TraceStep> steps; ///< in order
};

/// Maximum number of bodies with their own digit. More are arranged in a square, numbered row by
/// row, with a digit per row, a slash, and a digit per column. A single different body is at the
/// intersection of its row and column.
inline constexpr int kLongestTrace = 256;

/// Returns one line per step.
std::string ToText(const StateTrace& trace);
/// Parses the result of ToText. An Error contains the invalid line.
Result<StateTrace> ParseStateTrace(std::string_view text);

/// The first difference of two traces.
struct TraceDifference
{
    std::int64_t step = 0;   ///< first step that differs
    std::vector<int> bodies; ///< bodies that may differ there, by number; empty: unknown
    bool isOfOne = false;    ///< only one of the traces contains that step
    bool isFirst = false;    ///< no earlier step was compared, so the difference may have started
                             ///< before
};

/// Returns the first difference; none if both have equal steps. A digit may be equal by chance (one
/// in 16) for a different body. The step is exact, except when the states already differ before the
/// traces start.
std::optional<TraceDifference> FirstDifference(const StateTrace& expected,
                                               const StateTrace& actual);

/// Returns "from step 43 on, body 17 first", or "at step 121, if not before, body 17".
std::string Describe(const TraceDifference& difference);

} // namespace boxreel
