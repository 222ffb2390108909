// SPDX-License-Identifier: MIT
#include "FilmThumbnail.h"

#include <base/ErrorMacros.h>
#include <render/Png.h>

#include <algorithm>

namespace boxreel
{

std::int64_t FilmThumbnail::Index() const
{
    const std::int64_t count = m_plan.frames.Count();
    return m_options.thumbnail.at
               ? std::min(StepAt(*m_options.thumbnail.at, m_plan.film.framesPerSecond), count - 1)
               : count / 2;
}

void FilmThumbnail::See(std::int64_t index, const Frame& pixels)
{
    if (index == Index())
    {
        m_pixels = pixels;
    }
}

Result<void> FilmThumbnail::Draw(Renderer& renderer, const FrameContent& content)
{
    const Overlay* overlay = content.overlay.IsEmpty() ? nullptr : &content.overlay;
    return renderer.Draw(content.list, content.camera, m_pixels, overlay);
}

Result<void> FilmThumbnail::Write(Renderer& renderer)
{
    if (!IsWanted())
    {
        return {};
    }
    if (m_pixels.rgba.empty())
    {
        RETURN_IF_ERROR(renderer.Read(m_pixels));
    }
    return WritePng(m_options.thumbnail.file, m_pixels, {.overwrite = m_options.film.overwrite});
}

} // namespace boxreel
