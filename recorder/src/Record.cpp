// SPDX-License-Identifier: MIT
#include <recorder/Recording.h>

#include "EncoderThread.h"

#include <cassert>
#include <span>
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
        : m_settings(settings), m_renderer(renderer), m_writer(writer),
          m_frameCount(settings.frameCount), m_encoder(writer, settings.stages)
    {}

    Result<RecordingEnd> Run();

private:
    Result<void> Fill(std::int64_t frame);
    Result<void> Submit();
    Result<void> Make(std::int64_t frame);
    Result<const Frame*> Read();
    Result<void> HandOver();
    Result<void> Repeat();
    bool Report(std::int64_t framesDone);
    Result<RecordingEnd> Stop();
    Result<RecordingEnd> Finish();

    const RecordingSettings& m_settings;
    Renderer& m_renderer;
    VideoWriter& m_writer;
    FrameContent m_content;
    std::int64_t m_frameCount;       // until a frame says that it is the last
    const Frame* m_pixels = nullptr; // the renderer's
    std::int64_t m_reported = 0;
    std::int64_t m_repeated = 0;
    bool m_isBegun = false; // the encoder has a frame
    EncoderThread m_encoder;
};

Result<RecordingEnd> Recorder::Run()
{
    if (Result<void> filled = Fill(0); !filled)
    {
        return filled.GetError();
    }
    for (std::int64_t frame = 0; frame < m_frameCount; ++frame)
    {
        if (m_content.stops)
        {
            return Stop();
        }
        if (Result<void> made = Make(frame); !made)
        {
            return made.GetError();
        }
        if (!Report(m_encoder.FramesDone()))
        {
            return Stop();
        }
    }
    return Finish();
}

/// What was handed over is still encoded.
Result<RecordingEnd> Recorder::Stop()
{
    if (Result<void> finished = m_encoder.Finish(); !finished)
    {
        return finished.GetError();
    }
    Report(m_encoder.FramesDone()); // its answer is known
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
    const StageTimer timer(m_settings.stages, Stage::Draw);
    const Overlay* overlay = m_content.overlay.IsEmpty() ? nullptr : &m_content.overlay;
    return m_renderer.Submit(m_content.list, m_content.camera, overlay);
}

/// Submits frame `frame`, fills the next while it is drawn, hands its pixels to the encoder.
Result<void> Recorder::Make(std::int64_t frame)
{
    if (Result<void> submitted = Submit(); !submitted)
    {
        return submitted;
    }
    // The renderer may have drawn the same before this film began, but the film has no frame to
    // repeat then.
    const bool isRepeat = m_isBegun && m_renderer.Statistics().unchanged;
    if (frame + 1 < m_frameCount)
    {
        if (Result<void> filled = Fill(frame + 1); !filled)
        {
            return filled;
        }
    }
    if (Result<void> handed = isRepeat ? Repeat() : HandOver(); !handed)
    {
        return handed;
    }
    m_repeated += isRepeat ? 1 : 0;
    m_isBegun = true;
    if (m_settings.seen)
    {
        m_settings.seen(frame, *m_pixels);
    }
    return {};
}

Result<const Frame*> Recorder::Read()
{
    const StageTimer timer(m_settings.stages, Stage::Read);
    return m_renderer.ReadChanges();
}

/// Reads what has changed and hands it to the encoder.
Result<void> Recorder::HandOver()
{
    const Result<const Frame*> read = Read();
    if (!read)
    {
        return read.GetError();
    }
    m_pixels = *read;
    const Frame& frame = *m_pixels;
    const PixelBounds whole{0, 0, frame.width, frame.height};
    const std::span<const PixelBounds> changed =
        m_isBegun ? m_renderer.Changes() : std::span(&whole, 1);
    return m_encoder.Append(frame, changed) ? Result<void>() : m_encoder.Finish();
}

Result<void> Recorder::Repeat()
{
    return m_encoder.Repeat() ? Result<void>() : m_encoder.Finish();
}

/// False when the caller wants to stop.
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
    std::int64_t done = m_encoder.FramesDone();
    while (done < m_frameCount)
    {
        const std::int64_t more = m_encoder.WaitForMore(done);
        if (more == done) // the writer has failed
        {
            break;
        }
        done = more;
        if (!Report(done))
        {
            return Stop();
        }
    }
    if (Result<void> finished = m_encoder.Finish(); !finished)
    {
        return finished.GetError();
    }
    if (Result<void> closed = m_writer.Close(); !closed)
    {
        return closed.GetError();
    }
    return RecordingEnd::Complete;
}

} // namespace

Result<RecordingEnd> Record(const RecordingSettings& settings, Renderer& renderer,
                            VideoWriter& writer)
{
    assert(settings.fill && "a recording needs somebody who fills its frames");
    if (settings.frameCount < 1)
    {
        return Error{ErrorKind::Unusable, "A film of " + std::to_string(settings.frameCount) +
                                              " frames cannot be made; record at least one."};
    }
    return Recorder(settings, renderer, writer).Run();
}

} // namespace boxreel
