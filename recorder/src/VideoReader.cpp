// SPDX-License-Identifier: MIT
#include <recorder/VideoReader.h>

#include "FFmpegReader.h"
#include "PngSequence.h"
#include "VideoFormat.h"
#include "VideoSource.h"
#include "WebPReader.h"

#include <base/ErrorMacros.h>
#include <render/Png.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace boxreel
{

namespace
{

/// An animated PNG of one frame is a plain PNG, which libav does not accept as a film.
class StillReader final : public VideoSource
{
public:
    explicit StillReader(Frame frame) : m_frame(std::move(frame))
    {
        info = RgbInfo(m_frame->width, m_frame->height, Rational{1, 1}, "apng", "png");
    }

    Result<bool> Next(StoredFrame& stored) override
    {
        if (!m_frame)
        {
            return false;
        }
        stored.frame = *std::exchange(m_frame, std::nullopt);
        return true;
    }

private:
    std::optional<Frame> m_frame; // until returned
};

Result<std::unique_ptr<VideoSource>> OpenApng(const std::filesystem::path& path)
{
    Result<std::unique_ptr<VideoSource>> film = OpenFFmpegReader(path);
    if (film)
    {
        return film;
    }
    Result<Frame> still = ReadPng(path);
    if (!still)
    {
        return film.GetError();
    }
    return std::unique_ptr<VideoSource>(std::make_unique<StillReader>(std::move(*still)));
}

} // namespace

VideoInfo RgbInfo(int width, int height, const Rational& framesPerSecond,
                  const std::string& container, const std::string& codec)
{
    return {.width = width,
            .height = height,
            .framesPerSecond = framesPerSecond,
            .container = container,
            .codec = codec,
            .pixelFormat = "rgba",
            .colorSpace = "gbr",
            .colorPrimaries = "bt709",
            .colorTransfer = "iec61966-2-1",
            .colorRange = "pc"};
}

Result<std::unique_ptr<VideoSource>> OpenVideoSource(const std::filesystem::path& path)
{
    const std::optional<VideoFormat> format = FormatOf(path, {});
    return format == VideoFormat::Apng          ? OpenApng(path)
           : format == VideoFormat::PngSequence ? OpenPngSequenceSource(path)
           : format == VideoFormat::WebP        ? OpenWebPReader(path)
                                                : OpenFFmpegReader(path);
}

struct VideoReader::Impl
{
    std::unique_ptr<VideoSource> source;
    Frames frames = Frames::Shown;
    StoredFrame current; ///< the shown frame
    StoredFrame next;    ///< the following frame
    bool isBegun = false;
    bool hasNext = false;
    double start = 0.0;          ///< start of the first frame [s]
    std::int64_t timesShown = 0; ///< how often the current frame was returned
    std::int64_t timesToBeShown = 0;

    Result<bool> Advance();
    std::int64_t PeriodOf(double seconds) const;
};

/// Returns the number of the period in which a frame with this time starts.
std::int64_t VideoReader::Impl::PeriodOf(double seconds) const
{
    return std::llround((seconds - start) * source->info.framesPerSecond.ToDouble());
}

/// Makes the next frame the current one and finds its duration; false after the last.
Result<bool> VideoReader::Impl::Advance()
{
    if (!isBegun)
    {
        isBegun = true;
        ASSIGN_OR_RETURN(bool first, source->Next(next));
        hasNext = first;
        start = next.seconds;
    }
    if (!hasNext)
    {
        return false;
    }
    std::swap(current, next);
    ASSIGN_OR_RETURN(bool more, source->Next(next));
    hasNext = more;
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
    auto impl = std::make_unique<Impl>();
    ASSIGN_OR_RETURN(impl->source, OpenVideoSource(path));
    // The rate of an animated WebP is unknown: its frames are returned once each.
    impl->frames = FormatOf(path, {}) == VideoFormat::WebP ? Frames::Stored : frames;
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
