// SPDX-License-Identifier: MIT
#include <recorder/VideoWriter.h>

#include "FFmpegEncoder.h"
#include "PngSequence.h"
#include "VideoFormat.h"
#include "VideoSink.h"

#include <cassert>
#include <string>
#include <utility>

namespace boxreel
{

struct VideoWriter::Impl
{
    std::unique_ptr<VideoSink> sink; ///< none after Close or an Error
    int width = 0;
    int height = 0;
    std::int64_t frames = 0;

    /// After an Error the sink goes, and with it what it wrote.
    Result<void> Keep(Result<void> result)
    {
        if (!result)
        {
            sink.reset();
        }
        return result;
    }
};

VideoWriter::VideoWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<VideoWriter> VideoWriter::Open(const std::filesystem::path& path,
                                      const VideoSettings& settings)
{
    if (Result<void> checked = CheckVideoPath(path, settings); !checked)
    {
        return checked.GetError();
    }
    const VideoFormat format = *FormatOf(path);
    Result<std::unique_ptr<VideoSink>> sink = format == VideoFormat::PngSequence
                                                  ? OpenPngSequence(path, settings)
                                                  : OpenFFmpegEncoder(path, format, settings);
    if (!sink)
    {
        return sink.GetError();
    }
    auto impl = std::make_unique<Impl>();
    impl->sink = std::move(*sink);
    impl->width = settings.width;
    impl->height = settings.height;
    return VideoWriter(std::move(impl));
}

Result<void> VideoWriter::Append(const Frame& frame)
{
    assert(m_impl->sink && "nothing can be appended after Close or an Error");
    assert(frame.width == m_impl->width && frame.height == m_impl->height &&
           "a film's frames are of one size");
    if (!m_impl->sink || frame.width != m_impl->width || frame.height != m_impl->height)
    {
        return Error{ErrorKind::Failed,
                     "A frame of another size, or after the end, cannot be appended to a film."};
    }
    ++m_impl->frames;
    return m_impl->Keep(m_impl->sink->Append(frame));
}

Result<void> VideoWriter::Repeat()
{
    assert(m_impl->sink && m_impl->frames > 0 && "there must be a frame to repeat");
    if (!m_impl->sink || m_impl->frames == 0)
    {
        return Error{ErrorKind::Failed,
                     "A film has no frame to repeat before its first or after its end."};
    }
    return m_impl->Keep(m_impl->sink->Repeat());
}

Result<void> VideoWriter::Close()
{
    assert(m_impl->sink && "a film is closed once");
    if (!m_impl->sink)
    {
        return Error{ErrorKind::Failed,
                     "A film that is closed already, or failed, cannot be closed."};
    }
    if (m_impl->frames == 0)
    {
        m_impl->sink.reset();
        return Error{ErrorKind::Unusable,
                     "A film without a frame is none; append at least one before Close."};
    }
    Result<void> closed = m_impl->sink->Close();
    m_impl->sink.reset();
    return closed;
}

} // namespace boxreel
