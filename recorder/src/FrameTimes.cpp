// SPDX-License-Identifier: MIT
#include "FrameTimes.h"

namespace boxreel
{

namespace
{

/// More frames than a film has.
constexpr std::int64_t kNoGroups = std::int64_t(1) << 40;

std::int64_t GroupFrames(VideoFormat format, const VideoSettings& settings)
{
    return settings.groupFrames > 0 ? settings.groupFrames
           : IsAnimation(format)    ? kPartFrames
                                    : kNoGroups;
}

} // namespace

FrameTimes::FrameTimes(VideoFormat format, const VideoSettings& settings)
    : m_isGif(format == VideoFormat::Gif), m_framesPerSecond(settings.framesPerSecond),
      m_frames(settings.frames), m_step(m_isGif ? GifFrameStep(settings.framesPerSecond) : 1),
      m_groupFrames(GroupFrames(format, settings) * m_step), m_hasGroups(m_groupFrames < kNoGroups)
{}

std::int64_t FrameTimes::NumberOf(std::int64_t index) const
{
    // Frames with gaps form a separate film, which is not a part of another.
    return m_frames.IsWhole() ? m_frames.First() + index : index;
}

bool FrameTimes::IsKept(std::int64_t index) const
{
    return NumberOf(index) % m_step == 0;
}

std::int64_t FrameTimes::TimeOf(std::int64_t index) const
{
    if (!m_isGif)
    {
        return index;
    }
    return GifTimeOfFrame(NumberOf(index), m_framesPerSecond) -
           GifTimeOfFrame(NumberOf(0), m_framesPerSecond);
}

std::int64_t FrameTimes::IndexAt(std::int64_t time) const
{
    if (!m_isGif)
    {
        return time;
    }
    std::int64_t index = time * m_framesPerSecond.num / (100 * m_framesPerSecond.den);
    while (index > 0 && TimeOf(index) > time)
    {
        --index;
    }
    while (TimeOf(index + 1) <= time)
    {
        ++index;
    }
    return index;
}

std::int64_t FrameTimes::GroupOf(std::int64_t index) const
{
    return NumberOf(index) / m_groupFrames;
}

std::int64_t FrameTimes::FirstIndexOf(std::int64_t group) const
{
    return group * m_groupFrames - NumberOf(0);
}

} // namespace boxreel
