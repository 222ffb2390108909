// SPDX-License-Identifier: MIT
#include <recorder/Recording.h>

#include "FrameRelay.h"

#include <base/ErrorMacros.h>

#include <optional>
#include <utility>

namespace boxreel
{

struct Recording::Impl
{
    Impl(VideoWriter&& film, Renderer&& drawer)
        : writer(std::move(film)), renderer(std::move(drawer)), relay(renderer, writer)
    {}

    Result<void> Add(const DrawList& list, const Camera& camera, const Overlay* overlay);
    Result<void> Close();
    Result<void> HandOver();
    bool Keep(const Result<void>& result);

    VideoWriter writer;
    Renderer renderer;
    bool isDrawing = false; // the last frame is not passed to the encoder yet
    std::optional<Error> error;
    FrameRelay relay;
};

Result<void> Recording::Impl::HandOver()
{
    const bool wasDrawing = std::exchange(isDrawing, false);
    return wasDrawing ? relay.HandOver() : Result<void>();
}

Result<void> Recording::Impl::Add(const DrawList& list, const Camera& camera,
                                  const Overlay* overlay)
{
    RETURN_IF_ERROR(HandOver());
    Result<void> submitted = relay.Submit(list, camera, overlay);
    isDrawing = bool(submitted);
    return submitted;
}

Result<void> Recording::Impl::Close()
{
    RETURN_IF_ERROR(HandOver());
    RETURN_IF_ERROR(relay.Encoder().Finish());
    return writer.Close();
}

bool Recording::Impl::Keep(const Result<void>& result)
{
    if (!result)
    {
        error = result.GetError();
    }
    return bool(result);
}

Recording::Recording(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Recording::Recording(Recording&&) noexcept = default;
Recording& Recording::operator=(Recording&&) noexcept = default;
Recording::~Recording() = default;

Result<Recording> Recording::Open(const std::filesystem::path& path, const VideoSettings& film,
                                  const RendererSettings& drawing)
{
    RendererSettings ofSize = drawing;
    ofSize.width = film.width;
    ofSize.height = film.height;
    ASSIGN_OR_RETURN(Renderer renderer, Renderer::Create(ofSize));
    ASSIGN_OR_RETURN(VideoWriter writer, VideoWriter::Open(path, film));
    return Recording(std::make_unique<Impl>(std::move(writer), std::move(renderer)));
}

bool Recording::Add(const DrawList& list, const Camera& camera, const Overlay* overlay)
{
    return !m_impl->error && m_impl->Keep(m_impl->Add(list, camera, overlay));
}

Result<void> Recording::Close()
{
    return !m_impl->error && m_impl->Keep(m_impl->Close()) ? Result<void>() : *m_impl->error;
}

} // namespace boxreel
