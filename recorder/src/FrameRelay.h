// SPDX-License-Identifier: MIT
#pragma once

#include "EncoderThread.h"

#include <recorder/StageTimes.h>
#include <recorder/VideoWriter.h>
#include <render/Renderer.h>

/// A renderer's frames on their way into a film: what is submitted is drawn while its caller does
/// something else, then read where it has changed, and encoded on another thread. Used by Record
/// and Recording.
namespace boxreel
{

class FrameRelay
{
public:
    /// Both belong to the relay until it ends.
    FrameRelay(Renderer& renderer, VideoWriter& writer);

    Result<void> Submit(const DrawList& list, const Camera& camera, const Overlay* overlay);

    /// What was submitted last becomes the film's next frame.
    Result<void> HandOver();

    bool WasRepeated() const { return m_isRepeat; }   ///< the frame handed over last
    const Frame& Pixels() const { return *m_pixels; } ///< of it
    EncoderThread& Encoder() { return m_encoder; }    ///< to wait for
    const EncoderThread& Encoder() const { return m_encoder; }

private:
    Result<const Frame*> Read();
    Result<void> Append();

    Renderer& m_renderer;
    StageTimes* m_stages;
    const Frame* m_pixels = nullptr; // the renderer's
    bool m_isBegun = false;          // the encoder has a frame
    bool m_isRepeat = false;
    EncoderThread m_encoder;
};

} // namespace boxreel
