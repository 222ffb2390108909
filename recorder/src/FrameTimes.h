// SPDX-License-Identifier: MIT
#pragma once

#include "VideoFormat.h"

#include <cstdint>

/// When each frame of a film is shown, and to which group it belongs. `index`: its place among
/// those that are made; a part of a film is without those before and after it. Times count from the
/// first frame that is made, in the format's ticks; groups by the numbers in the whole film.
namespace boxreel
{

class FrameTimes
{
public:
    FrameTimes(VideoFormat format, const VideoSettings& settings);

    std::int64_t NumberOf(std::int64_t index) const;     ///< also one beyond the last
    bool IsKept(std::int64_t index) const;               ///< false for frames a GIF leaves out
    std::int64_t TimeOf(std::int64_t index) const;       ///< [ticks]
    std::int64_t IndexAt(std::int64_t time) const;       ///< of the frame that is shown then
    std::int64_t GroupOf(std::int64_t index) const;      ///< rises by 1 where one ends
    std::int64_t FirstIndexOf(std::int64_t group) const; ///< may be that of no frame: below 0

private:
    bool m_isGif;
    Rational m_framesPerSecond;
    FrameRange m_frames;
    std::int64_t m_step;        // between frames that are kept
    std::int64_t m_groupFrames; // with those that are not
};

} // namespace boxreel
