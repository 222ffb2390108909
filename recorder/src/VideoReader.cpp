// SPDX-License-Identifier: MIT
#include <recorder/VideoReader.h>

#include "FFmpegReader.h"
#include "PngSequence.h"
#include "VideoFormat.h"
#include "VideoSource.h"

#include <utility>

namespace boxreel
{

struct VideoReader::Impl
{
    std::unique_ptr<VideoSource> source;
};

VideoReader::VideoReader(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
VideoReader::VideoReader(VideoReader&&) noexcept = default;
VideoReader& VideoReader::operator=(VideoReader&&) noexcept = default;
VideoReader::~VideoReader() = default;

Result<VideoReader> VideoReader::Open(const std::filesystem::path& path)
{
    Result<std::unique_ptr<VideoSource>> source = FormatOf(path) == VideoFormat::PngSequence
                                                      ? OpenPngSequenceSource(path)
                                                      : OpenFFmpegReader(path);
    if (!source)
    {
        return source.GetError();
    }
    auto impl = std::make_unique<Impl>();
    impl->source = std::move(*source);
    return VideoReader(std::move(impl));
}

const VideoInfo& VideoReader::Info() const
{
    return m_impl->source->info;
}

Result<bool> VideoReader::Next(Frame& frame, double* seconds)
{
    double time = 0.0;
    Result<bool> more = m_impl->source->Next(frame, time);
    if (seconds != nullptr && more && *more)
    {
        *seconds = time;
    }
    return more;
}

} // namespace boxreel
