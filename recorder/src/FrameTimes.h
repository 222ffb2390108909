// SPDX-License-Identifier: MIT
#pragma once

#include "VideoFormat.h"

#include <cstdint>

/// When each frame of a film is shown, and to which group it belongs. Frames have the numbers that
/// they have in the whole film, of which this one may be a part; times count from its first frame,
/// in the format's ticks.
namespace boxreel
{

class FrameTimes
{
public:
    FrameTimes(VideoFormat format, const VideoSettings& settings);

    /// False for frames that a GIF leaves out.
    bool IsKept(std::int64_t number) const { return number % m_step == 0; }

    std::int64_t TimeOf(std::int64_t number) const; ///< [ticks]

    /// The number of the frame that is shown at that time, or the last before it.
    std::int64_t NumberAt(std::int64_t time) const;

    std::int64_t GroupOf(std::int64_t number) const { return number / m_groupFrames; }
    std::int64_t FirstOfGroup(std::int64_t group) const { return group * m_groupFrames; }
    std::int64_t FirstFrame() const { return m_firstFrame; }

private:
    bool m_isGif;
    Rational m_framesPerSecond;
    std::int64_t m_step;        // between frames that are kept
    std::int64_t m_groupFrames; // with those that are not
    std::int64_t m_firstFrame;
};

} // namespace boxreel
