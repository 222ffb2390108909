// SPDX-License-Identifier: MIT
#include <base/ErrorMacros.h>
#include <recorder/Recording.h>

#include "FrameRelay.h"

#include <cassert>
#include <string>

namespace boxreel
{

namespace
{

/// One run of Record.
class Recorder
{
public:
    Recorder(const RecordingSettings& settings, Renderer& renderer, VideoWriter& writer)
        : m_settings(settings), m_writer(writer), m_frameCount(settings.frameCount),
          m_relay(renderer, writer)
    {}

    Result<RecordingEnd> Run();

private:
    Result<void> Fill(std::int64_t frame);
    Result<void> Submit();
    Result<void> Make(std::int64_t frame);
    bool Report(std::int64_t framesDone);
    Result<RecordingEnd> Stop();
    Result<RecordingEnd> Finish();

    const RecordingSettings& m_settings;
    VideoWriter& m_writer;
    FrameContent m_content;
    std::int64_t m_frameCount; // until a frame has isLast
    std::int64_t m_reported = 0;
    std::int64_t m_repeated = 0;
    FrameRelay m_relay;
};

Result<RecordingEnd> Recorder::Run()
{
    RETURN_IF_ERROR(Fill(0));
    for (std::int64_t frame = 0; frame < m_frameCount; ++frame)
    {
        if (m_content.stops)
        {
            return Stop();
        }
        RETURN_IF_ERROR(Make(frame));
        if (!Report(m_relay.Encoder().FramesDone()))
        {
            return Stop();
        }
    }
    return Finish();
}

/// Frames already appended are still encoded.
Result<RecordingEnd> Recorder::Stop()
{
    RETURN_IF_ERROR(m_relay.Encoder().Finish());
    Report(m_relay.Encoder().FramesDone()); // the result is not needed
    return RecordingEnd::Stopped;
}

Result<void> Recorder::Fill(std::int64_t frame)
{
    m_content.list.Clear();
    m_content.overlay.vertices.clear();
    m_content.overlay.indices.clear();
    m_content.overlay.commands.clear();
    m_content.isLast = false;
    m_content.stops = false;
    Result<void> filled = m_settings.fill(frame, m_content);
    m_frameCount = m_content.isLast ? frame + 1 : m_frameCount;
    return filled;
}

Result<void> Recorder::Submit()
{
    const Overlay* overlay = m_content.overlay.IsEmpty() ? nullptr : &m_content.overlay;
    return m_relay.Submit(m_content.list, m_content.camera, overlay);
}

/// Submits frame `frame`, fills the next while it is drawn, and passes its pixels to the encoder.
Result<void> Recorder::Make(std::int64_t frame)
{
    RETURN_IF_ERROR(Submit());
    if (frame + 1 < m_frameCount)
    {
        RETURN_IF_ERROR(Fill(frame + 1));
    }
    RETURN_IF_ERROR(m_relay.HandOver());
    m_repeated += m_relay.WasRepeated() ? 1 : 0;
    if (m_settings.seen)
    {
        m_settings.seen(frame, m_relay.Pixels());
    }
    return {};
}

/// False when the caller stops the recording.
bool Recorder::Report(std::int64_t framesDone)
{
    if (!m_settings.progress || framesDone == m_reported)
    {
        return true;
    }
    m_reported = framesDone;
    return m_settings.progress({framesDone, m_frameCount, m_repeated});
}

Result<RecordingEnd> Recorder::Finish()
{
    std::int64_t done = m_relay.Encoder().FramesDone();
    while (done < m_frameCount)
    {
        const std::int64_t more = m_relay.Encoder().WaitForMore(done);
        if (more == done) // the writer failed
        {
            break;
        }
        done = more;
        if (!Report(done))
        {
            return Stop();
        }
    }
    RETURN_IF_ERROR(m_relay.Encoder().Finish());
    RETURN_IF_ERROR(m_writer.Close());
    return RecordingEnd::Complete;
}

} // namespace

Result<RecordingEnd> Record(const RecordingSettings& settings, Renderer& renderer,
                            VideoWriter& writer)
{
    assert(settings.fill && "a recording needs a function that fills its frames");
    if (settings.frameCount < 1)
    {
        return Error{ErrorKind::Unusable, "frameCount " + std::to_string(settings.frameCount),
                     "must be at least 1"};
    }
    return Recorder(settings, renderer, writer).Run();
}

} // namespace boxreel
