// SPDX-License-Identifier: MIT
#include "AnimationCopy.h"
#include "FFmpegFilm.h"
#include "GifFilm.h"
#include "PngSequence.h"
#include "VideoFormat.h"
#include "VideoSink.h"
#include "WebPFilm.h"
#include <recorder/VideoWriter.h>

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>

#include <cassert>
#include <string>
#include <utility>

namespace boxreel
{

struct VideoWriter::Impl
{
    std::unique_ptr<VideoSink> sink; ///< null after Close or an Error
    int width = 0;
    int height = 0;
    bool isEmpty = true;                ///< no frame was appended
    std::int64_t resumed = 0;           ///< frames of an animation that were encoded again
    std::optional<std::int64_t> stored; ///< after the end
    StageTimes* stages = nullptr;

    /// After an Error the sink is destroyed, which removes its files.
    Result<void> Keep(Result<void> result)
    {
        if (!result)
        {
            sink.reset();
        }
        return result;
    }
};

namespace
{

Result<std::unique_ptr<VideoSink>> OpenSink(const std::filesystem::path& path, VideoFormat format,
                                            const VideoSettings& settings)
{
    switch (format)
    {
    case VideoFormat::PngSequence:
        return OpenPngSequence(path, settings);
    case VideoFormat::Gif:
        return OpenGifFilm(path, settings);
    case VideoFormat::WebP:
        return OpenWebPFilm(path, settings);
    default:
        return OpenFFmpegFilm(path, format, settings);
    }
}

} // namespace

VideoWriter::VideoWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<VideoWriter> VideoWriter::Open(const std::filesystem::path& path,
                                      const VideoSettings& settings)
{
    RETURN_IF_ERROR(CheckVideoPath(path, settings));
    auto impl = std::make_unique<Impl>();
    ASSIGN_OR_RETURN(impl->sink, OpenSink(path, *FormatOf(path, settings), settings));
    impl->width = settings.width;
    impl->height = settings.height;
    impl->stages = settings.stages;
    VideoWriter writer(std::move(impl));
    if (settings.resume && IsAnimation(*FormatOf(path, settings)))
    {
        RETURN_IF_ERROR(writer.Resume(PartPath(path), settings));
    }
    return writer;
}

/// Starts with the frames that can be kept of the interrupted film.
Result<void> VideoWriter::Resume(const std::filesystem::path& left, const VideoSettings& settings)
{
    const std::int64_t count = CountWholeAnimation(left, settings);
    if (count > 0)
    {
        RETURN_IF_ERROR(CopyAnimation(left, settings, count, *this));
    }
    m_impl->resumed = count;
    return m_impl->sink->TakePlace();
}

std::int64_t VideoWriter::ResumedFrames() const
{
    return m_impl->sink ? m_impl->resumed + m_impl->sink->ResumedFrames() : 0;
}

std::optional<std::int64_t> VideoWriter::StoredFrames() const
{
    return m_impl->stored;
}

StageTimes* VideoWriter::Stages() const
{
    return m_impl->stages;
}

Result<void> VideoWriter::Append(const Frame& frame)
{
    const PixelBounds whole{0, 0, frame.width, frame.height};
    return Append(frame, {&whole, 1});
}

Result<void> VideoWriter::Append(const Frame& frame, std::span<const PixelBounds> changed)
{
    assert(m_impl->sink && "nothing can be appended after Close or an Error");
    assert(frame.width == m_impl->width && frame.height == m_impl->height &&
           "a film's frames are of one size");
    if (!m_impl->sink || frame.width != m_impl->width || frame.height != m_impl->height)
    {
        return Error{ErrorKind::Failed, "frame",
                     "size differs from the film's, or the film has ended"};
    }
    m_impl->isEmpty = false;
    return m_impl->Keep(m_impl->sink->Append(frame, changed));
}

Result<void> VideoWriter::Repeat()
{
    assert(m_impl->sink && !m_impl->isEmpty && "there must be a frame to repeat");
    if (!m_impl->sink || m_impl->isEmpty)
    {
        return Error{ErrorKind::Failed, "film",
                     "has no frame to repeat before its first or after its end"};
    }
    return m_impl->Keep(m_impl->sink->Repeat());
}

Result<void> VideoWriter::End(Result<void> (VideoSink::*end)())
{
    assert(m_impl->sink && "a film is closed once");
    if (!m_impl->sink)
    {
        return Error{ErrorKind::Failed, "film", "is already closed, or has failed"};
    }
    if (m_impl->isEmpty && m_impl->sink->ResumedFrames() == 0)
    {
        m_impl->sink.reset();
        return Error{ErrorKind::Unusable, "film", "has no frame",
                     "append at least one before Close"};
    }
    Result<void> ended = (m_impl->sink.get()->*end)();
    m_impl->stored = m_impl->sink->StoredFrames();
    m_impl->sink.reset();
    return ended;
}

Result<void> VideoWriter::Close()
{
    return End(&VideoSink::Close);
}

Result<void> VideoWriter::Suspend()
{
    return End(&VideoSink::Suspend);
}

} // namespace boxreel
