// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// The frames of a film to record, by number: all, or a part for one of many machines.
namespace boxreel
{

/// The frames first, first + step, … up to last.
struct FrameRun
{
    std::int64_t first = 0; ///< number of the first frame, from 0
    /// Largest possible number.
    std::int64_t last = std::numeric_limits<std::int64_t>::max() - 1;
    std::int64_t step = 1; ///< at least 1

    /// Returns the number of frames.
    std::int64_t Count() const { return last < first ? 0 : (last - first) / step + 1; }
    /// True if all members are equal.
    friend bool operator==(const FrameRun&, const FrameRun&) = default;
};

/// A subset of a film's frames.
class FrameRange
{
public:
    FrameRange() : m_runs{FrameRun{}} {} ///< all frames, without an end
    /// Creates a range of one run, which must not be empty.
    explicit FrameRange(const FrameRun& run) : m_runs{run} {}

    /// Parses "200-399", "7", "1-3,5,7-20:2": ascending runs without overlap; a colon selects every
    /// n-th frame. An Error (Unusable) otherwise. Numbers below 10^12.
    static Result<FrameRange> Parse(std::string_view text);

    std::int64_t Count() const;                ///< number of frames
    std::int64_t At(std::int64_t index) const; ///< the number of a frame; 0 <= index < Count()
    /// Returns the number of the first frame.
    std::int64_t First() const { return m_runs.front().first; }
    /// Returns the number of the last frame.
    std::int64_t Last() const { return At(Count() - 1); }

    /// True if the range contains every number from the first to the last.
    bool IsWhole() const { return m_runs.size() == 1 && m_runs.front().step == 1; }

    /// Returns the frames below number `count`; may be empty.
    FrameRange Below(std::int64_t count) const;

    std::string Text() const; ///< in the format of Parse

    /// True if all members are equal.
    friend bool operator==(const FrameRange&, const FrameRange&) = default;

private:
    std::vector<FrameRun> m_runs; // at least one
};

} // namespace boxreel
