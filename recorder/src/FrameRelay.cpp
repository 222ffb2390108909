// SPDX-License-Identifier: MIT
#include "FrameRelay.h"

#include <base/ErrorMacros.h>

#include <span>

namespace boxreel
{

FrameRelay::FrameRelay(Renderer& renderer, VideoWriter& writer)
    : m_renderer(renderer), m_stages(writer.Stages()), m_encoder(writer)
{}

Result<void> FrameRelay::Submit(const DrawList& list, const Camera& camera, const Overlay* overlay)
{
    const StageTimer timer(m_stages, Stage::Draw);
    RETURN_IF_ERROR(m_renderer.Submit(list, camera, overlay));
    // The renderer may have drawn the same picture before this film started; then the film has no
    // frame to repeat.
    m_isRepeat = m_isBegun && m_renderer.Statistics().unchanged;
    return {};
}

Result<void> FrameRelay::HandOver()
{
    if (!m_isRepeat)
    {
        RETURN_IF_ERROR(Append());
    }
    else if (!m_encoder.Repeat())
    {
        return m_encoder.Finish();
    }
    m_isBegun = true;
    return {};
}

Result<const Frame*> FrameRelay::Read()
{
    const StageTimer timer(m_stages, Stage::Read);
    return m_renderer.ReadChanges();
}

/// Reads the changes and passes them to the encoder.
Result<void> FrameRelay::Append()
{
    ASSIGN_OR_RETURN(const Frame* read, Read());
    m_pixels = read;
    const PixelBounds whole{0, 0, m_pixels->width, m_pixels->height};
    const std::span<const PixelBounds> changed =
        m_isBegun ? m_renderer.Changes() : std::span(&whole, 1);
    return m_encoder.Append(*m_pixels, changed) ? Result<void>() : m_encoder.Finish();
}

} // namespace boxreel
