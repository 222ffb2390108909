// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Which frames of a film are made, by their numbers in the whole of it: all, or a part for one
/// machine of many. Knows no film.
namespace boxreel
{

/// first, first + step, … up to last.
struct FrameRun
{
    std::int64_t first = 0; ///< number of the first frame, from 0
    /// Number of the last that may be one.
    std::int64_t last = std::numeric_limits<std::int64_t>::max() - 1;
    std::int64_t step = 1; ///< at least 1

    /// How many frames.
    std::int64_t Count() const { return last < first ? 0 : (last - first) / step + 1; }
    /// Whether all members are equal.
    friend bool operator==(const FrameRun&, const FrameRun&) = default;
};

/// Some of a film's frames.
class FrameRange
{
public:
    FrameRange() : m_runs{FrameRun{}} {} ///< all frames, however many
    /// One run, which must not be empty.
    explicit FrameRange(const FrameRun& run) : m_runs{run} {}

    /// "200-399", "7", "1-3,5,7-20:2": runs in ascending order, without overlap, every n-th frame
    /// after a colon. An Error (Unusable) otherwise. Numbers below 10^12.
    static Result<FrameRange> Parse(std::string_view text);

    std::int64_t Count() const;                ///< of frames
    std::int64_t At(std::int64_t index) const; ///< the number of a frame; 0 <= index < Count()
    /// The number of the first frame.
    std::int64_t First() const { return m_runs.front().first; }
    /// The number of the last frame.
    std::int64_t Last() const { return At(Count() - 1); }

    /// Whether there is a frame for each number from the first to the last.
    bool IsWhole() const { return m_runs.size() == 1 && m_runs.front().step == 1; }

    /// Without the frames from number `count` on; may be empty then.
    FrameRange Below(std::int64_t count) const;

    std::string Text() const; ///< as Parse takes it

    /// Whether all members are equal.
    friend bool operator==(const FrameRange&, const FrameRange&) = default;

private:
    std::vector<FrameRun> m_runs; // at least one
};

} // namespace boxreel
