// SPDX-License-Identifier: MIT
#include <recorder/VideoReader.h>

#include "FFmpegReader.h"
#include "PngSequence.h"
#include "VideoFormat.h"
#include "VideoSource.h"
#include "WebPReader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace boxreel
{

struct VideoReader::Impl
{
    std::unique_ptr<VideoSource> source;
    Frames frames = Frames::Shown;
    StoredFrame current; ///< what is shown
    StoredFrame next;    ///< what comes after it
    bool isBegun = false;
    bool hasNext = false;
    double start = 0.0;          ///< when the first is shown [s]
    std::int64_t timesShown = 0; ///< how often the current one came
    std::int64_t timesToBeShown = 0;

    Result<bool> Advance();
    std::int64_t PeriodOf(double seconds) const;
};

/// The number of the period in which something shown at this time begins.
std::int64_t VideoReader::Impl::PeriodOf(double seconds) const
{
    return std::llround((seconds - start) * source->info.framesPerSecond.ToDouble());
}

/// Makes the next frame the current one, and looks for how long it stays; false after the last.
Result<bool> VideoReader::Impl::Advance()
{
    if (!isBegun)
    {
        isBegun = true;
        Result<bool> first = source->Next(next);
        if (!first)
        {
            return first;
        }
        hasNext = *first;
        start = next.seconds;
    }
    if (!hasNext)
    {
        return false;
    }
    std::swap(current, next);
    Result<bool> more = source->Next(next);
    if (!more)
    {
        return more;
    }
    hasNext = *more;
    const double end = hasNext ? next.seconds : current.seconds + current.length;
    timesShown = 0;
    timesToBeShown = std::max<std::int64_t>(1, PeriodOf(end) - PeriodOf(current.seconds));
    return true;
}

VideoReader::VideoReader(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
VideoReader::VideoReader(VideoReader&&) noexcept = default;
VideoReader& VideoReader::operator=(VideoReader&&) noexcept = default;
VideoReader::~VideoReader() = default;

Result<VideoReader> VideoReader::Open(const std::filesystem::path& path, Frames frames)
{
    const std::optional<VideoFormat> format = FormatOf(path, {});
    Result<std::unique_ptr<VideoSource>> source =
        format == VideoFormat::PngSequence ? OpenPngSequenceSource(path)
        : format == VideoFormat::WebP      ? OpenWebPReader(path)
                                           : OpenFFmpegReader(path);
    if (!source)
    {
        return source.GetError();
    }
    auto impl = std::make_unique<Impl>();
    impl->source = std::move(*source);
    // The rate of an animated WebP is not known: its frames come once each.
    impl->frames = format == VideoFormat::WebP ? Frames::Stored : frames;
    return VideoReader(std::move(impl));
}

const VideoInfo& VideoReader::Info() const
{
    return m_impl->source->info;
}

Result<bool> VideoReader::Next(Frame& frame, double* seconds)
{
    Impl& impl = *m_impl;
    if (impl.timesShown >= impl.timesToBeShown || impl.frames == Frames::Stored)
    {
        if (Result<bool> more = impl.Advance(); !more || !*more)
        {
            return more;
        }
    }
    frame = impl.current.frame;
    if (seconds != nullptr)
    {
        const Rational& rate = impl.source->info.framesPerSecond;
        *seconds = impl.current.seconds + double(impl.timesShown * rate.den) / double(rate.num);
    }
    ++impl.timesShown;
    return true;
}

} // namespace boxreel
