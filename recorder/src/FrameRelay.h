// SPDX-License-Identifier: MIT
#pragma once

#include "EncoderThread.h"

#include <recorder/StageTimes.h>
#include <recorder/VideoWriter.h>
#include <render/Renderer.h>

/// Passes a renderer's frames to a film. Submitted frames are drawn while the caller continues,
/// read where they changed, and encoded on another thread. Used by Record and Recording.
namespace boxreel
{

class FrameRelay
{
public:
    /// Only the relay may use both until it is destroyed.
    FrameRelay(Renderer& renderer, VideoWriter& writer);

    Result<void> Submit(const DrawList& list, const Camera& camera, const Overlay* overlay);

    /// Appends the last submitted picture to the film.
    Result<void> HandOver();

    bool WasRepeated() const
    {
        return m_isRepeat;
    }                                                 ///< true if the last appended frame was a
                                                      ///< repetition
    const Frame& Pixels() const { return *m_pixels; } ///< its pixels
    EncoderThread& Encoder() { return m_encoder; }    ///< to wait for frames
    const EncoderThread& Encoder() const { return m_encoder; }

private:
    Result<const Frame*> Read();
    Result<void> Append();

    Renderer& m_renderer;
    StageTimes* m_stages;
    const Frame* m_pixels = nullptr; // owned by the renderer
    bool m_isBegun = false;          // the encoder has received a frame
    bool m_isRepeat = false;
    EncoderThread m_encoder;
};

} // namespace boxreel
