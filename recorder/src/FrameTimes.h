// SPDX-License-Identifier: MIT
#pragma once

#include "VideoFormat.h"

#include <cstdint>

/// The time and group of each frame of a film. `index` counts the recorded frames; a part of a film
/// does not contain those before and after it. Times start at the first recorded frame, in the
/// format's ticks. Groups follow the numbers in the whole film.
namespace boxreel
{

class FrameTimes
{
public:
    FrameTimes(VideoFormat format, const VideoSettings& settings);

    std::int64_t NumberOf(std::int64_t index) const;     ///< also valid one past the last
    bool IsKept(std::int64_t index) const;               ///< false for frames a GIF omits
    std::int64_t TimeOf(std::int64_t index) const;       ///< [ticks]
    std::int64_t IndexAt(std::int64_t time) const;       ///< index of the frame shown at this time
    bool HasGroups() const { return m_hasGroups; }       ///< false: all frames are in group 0
    std::int64_t GroupOf(std::int64_t index) const;      ///< increases by 1 after the last frame of
                                                         ///< a group
    std::int64_t FirstIndexOf(std::int64_t group) const; ///< may be negative for a part

private:
    bool m_isGif;
    Rational m_framesPerSecond;
    FrameRange m_frames;
    std::int64_t m_step;        // between kept frames
    std::int64_t m_groupFrames; // including omitted frames
    bool m_hasGroups;
};

} // namespace boxreel
