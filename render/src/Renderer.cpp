// SPDX-License-Identifier: MIT
#include <render/Renderer.h>

#include "Batches.h"
#include "Canvas.h"
#include "Context.h"
#include "ShapeBuilder.h"

#include <cmath>

namespace boxreel
{
namespace
{

constexpr int kMaxSize = 8192;
constexpr double kMinScale = 0.1; // letters of 1.5 px
constexpr double kMaxScale = 16.0;

std::string Size(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

Result<void> CheckCamera(const Camera& camera, const RendererSettings& settings)
{
    if (camera.width != settings.width || camera.height != settings.height)
    {
        return Error{ErrorKind::Unusable,
                     "the camera's picture of " + Size(camera.width, camera.height) +
                         " is not of the renderer's size " + Size(settings.width, settings.height) +
                         "; give both the same"};
    }
    if (!std::isfinite(camera.centerX) || !std::isfinite(camera.centerY) ||
        !std::isfinite(camera.pixelsPerMeter) || camera.pixelsPerMeter <= 0.0)
    {
        return Error{ErrorKind::Unusable, "the camera's centre and scale must be finite and its "
                                          "scale above zero; check pixelsPerMeter"};
    }
    return {};
}

} // namespace

/// What the last Submit drew, to tell when the next one is the same.
struct Submitted
{
    DrawList list;
    Camera camera;
    Overlay overlay;

    bool Equals(const DrawList& otherList, const Camera& otherCamera,
                const Overlay& otherOverlay) const
    {
        return camera == otherCamera && list == otherList && overlay == otherOverlay;
    }
};

struct Renderer::Impl
{
    explicit Impl(const RendererSettings& chosen) : settings(chosen) {}
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl()
    {
        if (context && context->MakeCurrent())
        {
            canvas.reset();
        }
    }

    RendererSettings settings;
    std::unique_ptr<Context> context;
    std::unique_ptr<Canvas> canvas; // after the context, which must outlive it
    std::string description;
    Batches batches;
    RenderStatistics statistics;
    Submitted last;
    bool hasLast = false;
};

Renderer::Renderer(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::Create(const RendererSettings& settings)
{
    if (settings.width < 1 || settings.width > kMaxSize || settings.height < 1 ||
        settings.height > kMaxSize)
    {
        return Error{ErrorKind::Unusable,
                     "a picture of " + Size(settings.width, settings.height) +
                         " pixels cannot be drawn; width and height go from 1 to " +
                         std::to_string(kMaxSize)};
    }
    if (!(settings.scale >= kMinScale && settings.scale <= kMaxScale))
    {
        return Error{ErrorKind::Unusable, "pixels cannot be scaled by " +
                                              std::to_string(settings.scale) +
                                              "; give a scale from 0.1 to 16"};
    }
    auto impl = std::make_unique<Impl>(settings);
    Result<std::unique_ptr<Context>> context = CreateContext(settings.backend);
    if (!context)
    {
        return context.GetError();
    }
    impl->context = std::move(*context);
    if (Result<void> current = impl->context->MakeCurrent(); !current)
    {
        return current.GetError();
    }
    Result<std::unique_ptr<Canvas>> canvas =
        Canvas::Create(*impl->context, settings.width, settings.height, settings.scale);
    if (!canvas)
    {
        return canvas.GetError();
    }
    impl->canvas = std::move(*canvas);
    impl->description = std::string(impl->context->BackEnd()) + ", " + impl->canvas->Description();
    return Renderer(std::move(impl));
}

Result<void> Renderer::Submit(const DrawList& list, const Camera& camera, const Overlay* overlay)
{
    static const Overlay kNothing;
    Impl& impl = *m_impl;
    const Overlay& top = overlay ? *overlay : kNothing;
    if (Result<void> checked = CheckCamera(camera, impl.settings); !checked)
    {
        return checked;
    }
    impl.statistics = {};
    impl.statistics.unchanged = impl.hasLast && impl.last.Equals(list, camera, top);
    if (impl.statistics.unchanged)
    {
        return {};
    }
    if (Result<void> current = impl.context->MakeCurrent(); !current)
    {
        return current;
    }
    impl.hasLast = false; // until all of it is drawn
    impl.batches.Clear(camera.width, camera.height);
    ShapeBuilder builder(camera, impl.settings.theme, impl.settings.scale, impl.batches);
    for (const DrawItem& item : list.items)
    {
        ++(builder.Add(list, item) ? impl.statistics.itemsDrawn : impl.statistics.itemsSkipped);
    }
    impl.statistics.drawCalls = impl.batches.All().size();
    impl.canvas->Clear(impl.settings.theme.background);
    if (Result<void> drawn = impl.canvas->Draw(impl.batches.All()); !drawn)
    {
        return drawn;
    }
    if (Result<void> drawn = impl.canvas->Draw(top); !drawn)
    {
        return drawn;
    }
    impl.canvas->Flush();
    impl.last.list = list;
    impl.last.camera = camera;
    impl.last.overlay = top;
    impl.hasLast = true;
    return {};
}

Result<void> Renderer::Read(Frame& frame)
{
    if (Result<void> current = m_impl->context->MakeCurrent(); !current)
    {
        return current;
    }
    return m_impl->canvas->Read(frame);
}

Result<void> Renderer::Draw(const DrawList& list, const Camera& camera, Frame& frame,
                            const Overlay* overlay)
{
    if (Result<void> submitted = Submit(list, camera, overlay); !submitted)
    {
        return submitted;
    }
    return Read(frame);
}

const RenderStatistics& Renderer::Statistics() const
{
    return m_impl->statistics;
}

const std::string& Renderer::Description() const
{
    return m_impl->description;
}

} // namespace boxreel
