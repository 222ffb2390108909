// SPDX-License-Identifier: MIT
#include "FrameTimes.h"

namespace boxreel
{

FrameTimes::FrameTimes(VideoFormat format, const VideoSettings& settings)
    : m_isGif(format == VideoFormat::Gif), m_framesPerSecond(settings.framesPerSecond),
      m_step(m_isGif ? GifFrameStep(settings.framesPerSecond) : 1),
      m_groupFrames(settings.groupFrames * m_step), m_firstFrame(settings.firstFrame)
{}

std::int64_t FrameTimes::TimeOf(std::int64_t number) const
{
    if (!m_isGif)
    {
        return number - m_firstFrame;
    }
    return GifTimeOfFrame(number, m_framesPerSecond) -
           GifTimeOfFrame(m_firstFrame, m_framesPerSecond);
}

std::int64_t FrameTimes::NumberAt(std::int64_t time) const
{
    if (!m_isGif)
    {
        return m_firstFrame + time;
    }
    const std::int64_t centiseconds = time + GifTimeOfFrame(m_firstFrame, m_framesPerSecond);
    std::int64_t number =
        centiseconds * m_framesPerSecond.num / (100 * m_framesPerSecond.den); // or the next one
    while (TimeOf(number + 1) <= time)
    {
        ++number;
    }
    return number;
}

} // namespace boxreel
