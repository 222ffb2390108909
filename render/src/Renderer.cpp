// SPDX-License-Identifier: MIT
#include <render/Renderer.h>

#include "Batches.h"
#include "Canvas.h"
#include "Context.h"
#include "ContextWindow.h"
#include "DirtyTiles.h"
#include "ListMatch.h"
#include "OverlayChange.h"
#include "Parts.h"
#include "Probe.h"
#include "ShapeBuilder.h"

#include <base/ErrorMacros.h>

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

constexpr int kMaxSize = 8192;
constexpr double kMinScale = 0.1; // text of 1.5 px
constexpr double kMaxScale = 16.0;

// A full redraw draws each instance once; a partial one as often as it has parts, plus cutting.
// Above this fraction of the picture the full redraw is not slower.
constexpr double kMaxShare = 0.6;

// This many extra quads are acceptable: they cost less than clearing and reading the whole picture.
constexpr std::size_t kQuadsToSpare = 256;

// Clean tiles included to reduce the number of rectangles. A quad costs as much as a few tiles of
// pixels, a read call as much as a hundred.
constexpr int kDrawGap = 2;
constexpr int kReadGap = 12;

std::string Size(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

Result<void> CheckSettings(const RendererSettings& settings)
{
    if (settings.width < 1 || settings.width > kMaxSize || settings.height < 1 ||
        settings.height > kMaxSize)
    {
        return Error{ErrorKind::Unusable, "size " + Size(settings.width, settings.height),
                     "width and height must be between 1 and " + std::to_string(kMaxSize)};
    }
    if (!(settings.scale >= kMinScale && settings.scale <= kMaxScale))
    {
        return Error{ErrorKind::Unusable, "scale " + std::to_string(settings.scale),
                     "must be between 0.1 and 16"};
    }
    return {};
}

Result<void> CheckCamera(const Camera& camera, const RendererSettings& settings)
{
    if (camera.width != settings.width || camera.height != settings.height)
    {
        return Error{ErrorKind::Unusable, "camera",
                     "has size " + Size(camera.width, camera.height) +
                         ", but the renderer has size " + Size(settings.width, settings.height),
                     "use the same size for both"};
    }
    if (!CanBeDrawn(camera))
    {
        return Error{
            ErrorKind::Unusable, "camera",
            "centre and scale must be finite, the scale above zero, both at most 1e15 pixels",
            "check pixelsPerMeter"};
    }
    return {};
}

Result<void> CheckOverlay(const Overlay& overlay)
{
    for (const OverlayCommand& command : overlay.commands)
    {
        const std::uint64_t end = std::uint64_t(command.firstIndex) + command.indexCount;
        if (end > overlay.indices.size())
        {
            return Error{ErrorKind::Unusable, "overlay",
                         "a command draws up to index " + std::to_string(end) + " of " +
                             std::to_string(overlay.indices.size())};
        }
    }
    const auto maximum = std::max_element(overlay.indices.begin(), overlay.indices.end());
    if (maximum != overlay.indices.end() && *maximum >= overlay.vertices.size())
    {
        return Error{ErrorKind::Unusable, "overlay",
                     "an index refers to vertex " + std::to_string(*maximum) + " of " +
                         std::to_string(overlay.vertices.size()),
                     "count vertices from 0"};
    }
    return {};
}

/// Premultiplied, 0 to 1. A product of two bytes is never halfway between two steps of 1 / 255, so
/// clearing and drawing round it to the same bits.
std::array<float, 4> Premultiplied(Color color)
{
    const auto channel = [&](int value) { return float(value * color.a) / (255.0f * 255.0f); };
    return {channel(color.r), channel(color.g), channel(color.b), channel(255)};
}

} // namespace

/// Data of the last Submit, to find the changes of the next one.
struct Submitted
{
    DrawList list;
    Camera camera;
    Overlay overlay;
    Instances instances; // per item of the list

    bool Equals(const DrawList& otherList, const Camera& otherCamera,
                const Overlay& otherOverlay) const
    {
        return camera == otherCamera && list == otherList && overlay == otherOverlay;
    }
};

struct Renderer::Impl
{
    explicit Impl(const RendererSettings& chosen)
        : settings(chosen), builder(chosen.theme, chosen.scale),
          background(Premultiplied(chosen.theme.background)), dirty(chosen.width, chosen.height),
          unread(chosen.width, chosen.height)
    {
        unread.AddAll();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl()
    {
        const auto lock = LockGl();
        if (context)
        {
            (void)context->MakeCurrent();
        }
        canvas.reset();
        context.reset();
    }

    Result<void> Begin(std::unique_ptr<Context> drawn);
    void Build(const DrawList& list);
    void FindDirty(const Overlay& overlay);
    void Plan();
    bool PlanParts();
    void PlanWhole();
    Result<void> Draw(const Overlay& overlay);
    void Keep(const DrawList& list, const Camera& camera, const Overlay& overlay);
    void Count();

    bool IsWhole() const { return rectangles.size() == 1 && rectangles.front() == Picture(); }
    PixelBounds Picture() const { return {0, 0, settings.width, settings.height}; }

    RendererSettings settings;
    std::unique_ptr<Context> context;
    std::unique_ptr<Canvas> canvas; // after the context, which must outlive it
    std::string description;
    ShapeBuilder builder;
    std::array<float, 4> background; // premultiplied

    Submitted last;
    bool hasLast = false;

    // Data of the current Submit.
    Instances instances;
    std::vector<std::size_t> matches; // per item: the identical one in the last list
    DirtyTiles dirty;
    std::vector<PixelBounds> rectangles; // to redraw
    Batches batches;
    RenderStatistics statistics;
    RenderTotals totals;

    Frame frame;       // as last read
    DirtyTiles unread; // redrawn since then
    std::vector<PixelBounds> changes;
};

/// Converts the list to instances; copies those of items in the last list.
void Renderer::Impl::Build(const DrawList& list)
{
    instances.Clear();
    for (std::size_t i = 0; i < list.items.size(); ++i)
    {
        if (matches[i] != kNoMatch)
        {
            instances.CopyItem(last.instances, matches[i]);
            ++statistics.itemsReused;
        }
        else
        {
            builder.Add(list, list.items[i], instances);
            instances.EndItem();
        }
        statistics.itemsOutside += instances.OfItem(i).empty() ? 1 : 0;
    }
}

/// Marks the areas of inserted and removed items. Everywhere else the same instances are drawn in
/// the same order.
void Renderer::Impl::FindDirty(const Overlay& overlay)
{
    const auto add = [this](std::span<const Instance> item) {
        for (const Instance& instance : item)
        {
            dirty.Add(instance.bounds);
        }
    };
    std::size_t old = 0; // first item of the last list without a decision
    for (std::size_t i = 0; i < matches.size(); ++i)
    {
        if (matches[i] == kNoMatch)
        {
            add(instances.OfItem(i));
            continue;
        }
        for (; old < matches[i]; ++old)
        {
            add(last.instances.OfItem(old));
        }
        old = matches[i] + 1;
    }
    for (; old < last.instances.Items(); ++old)
    {
        add(last.instances.OfItem(old));
    }
    AddDifference(last.overlay, overlay, settings.width, settings.height, dirty);
}

/// Plans the redraw: the rectangles and their batches.
void Renderer::Impl::Plan()
{
    dirty.Gather(kDrawGap, rectangles);
    std::int64_t pixels = 0;
    for (const PixelBounds& rectangle : rectangles)
    {
        pixels += rectangle.Area();
    }
    if (double(pixels) > kMaxShare * double(Picture().Area()) || !PlanParts())
    {
        PlanWhole();
        pixels = Picture().Area();
    }
    statistics.rectangles = rectangles.size();
    statistics.pixels = pixels;
    statistics.drawCalls = batches.All().size();
}

/// False if it costs more than a full redraw.
bool Renderer::Impl::PlanParts()
{
    const std::size_t maximum = instances.All().size() + kQuadsToSpare;
    batches.Clear(settings.width, settings.height);
    for (const PixelBounds& r : rectangles)
    {
        batches.Add(ProgramKind::Ground, Form::Quad, r,
                    {float(r.x0), float(r.y0), float(r.x1), float(r.y1)}, background);
    }
    statistics.itemsDrawn = 0;
    for (std::size_t i = 0; i < instances.Items() && batches.Instances() <= maximum; ++i)
    {
        bool isDrawn = false;
        for (const Instance& instance : instances.OfItem(i))
        {
            if (dirty.Touches(instance.bounds))
            {
                for (const PixelBounds& rectangle : rectangles)
                {
                    if (rectangle.y0 >= instance.bounds.y1)
                    {
                        break; // as are all others, because they are sorted by y0
                    }
                    isDrawn |= AddPart(instances, instance, rectangle, batches);
                }
            }
        }
        statistics.itemsDrawn += isDrawn ? 1 : 0;
    }
    return batches.Instances() <= maximum;
}

void Renderer::Impl::PlanWhole()
{
    batches.Clear(settings.width, settings.height);
    for (const Instance& instance : instances.All())
    {
        AddWhole(instances, instance, batches);
    }
    statistics.itemsDrawn = statistics.items - statistics.itemsOutside;
    rectangles.assign(1, Picture());
}

Result<void> Renderer::Impl::Draw(const Overlay& overlay)
{
    for (const PixelBounds& rectangle : rectangles)
    {
        unread.Add(rectangle);
    }
    if (IsWhole())
    {
        canvas->Clear(background);
    }
    RETURN_IF_ERROR(canvas->Draw(batches.All()));
    RETURN_IF_ERROR(canvas->Draw(overlay, rectangles));
    canvas->Flush();
    return {};
}

void Renderer::Impl::Keep(const DrawList& list, const Camera& camera, const Overlay& overlay)
{
    last.list = list;
    last.camera = camera;
    last.overlay = overlay;
    std::swap(last.instances, instances);
    hasLast = true;
}

void Renderer::Impl::Count()
{
    ++totals.frames;
    totals.framesUnchanged += statistics.unchanged ? 1 : 0;
    totals.framesInPart += !statistics.unchanged && !IsWhole() ? 1 : 0;
    totals.pixels += Picture().Area();
    totals.pixelsDrawn += statistics.pixels;
    totals.items += std::int64_t(statistics.items);
    totals.itemsDrawn += std::int64_t(statistics.itemsDrawn);
    totals.itemsOutside += std::int64_t(statistics.itemsOutside);
    totals.itemsReused += std::int64_t(statistics.itemsReused);
    totals.drawCalls += std::int64_t(statistics.drawCalls);
}

RenderTotals& RenderTotals::operator+=(const RenderTotals& other)
{
    frames += other.frames;
    framesUnchanged += other.framesUnchanged;
    framesInPart += other.framesInPart;
    pixels += other.pixels;
    pixelsDrawn += other.pixelsDrawn;
    items += other.items;
    itemsDrawn += other.itemsDrawn;
    itemsOutside += other.itemsOutside;
    itemsReused += other.itemsReused;
    drawCalls += other.drawCalls;
    return *this;
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

/// Starts drawing in this context.
Result<void> Renderer::Impl::Begin(std::unique_ptr<Context> drawn)
{
    context = std::move(drawn);
    RETURN_IF_ERROR(context->MakeCurrent());
    ASSIGN_OR_RETURN(std::unique_ptr<Canvas> made,
                     Canvas::Create(*context, settings.width, settings.height, settings.scale));
    canvas = std::move(made);
    description = std::string(context->BackEnd()) + ", " + canvas->Description();
    return {};
}

Result<Renderer> Renderer::Create(const RendererSettings& settings)
{
    RETURN_IF_ERROR(CheckSettings(settings));
    const auto lock = LockGl();
    ASSIGN_OR_RETURN(std::unique_ptr<Context> context, CreateContext(settings.backend));
    auto impl = std::make_unique<Impl>(settings);
    const Result<void> begun = impl->Begin(std::move(context));
    return begun ? Result<Renderer>(Renderer(std::move(impl))) : begun.GetError();
}

Result<Renderer> Renderer::CreateIn(Window& window, const RendererSettings& settings)
{
    RETURN_IF_ERROR(CheckSettings(settings));
    const auto lock = LockGl();
    auto impl = std::make_unique<Impl>(settings);
    const Result<void> begun = impl->Begin(CreateWindowContext(window));
    return begun ? Result<Renderer>(Renderer(std::move(impl))) : begun.GetError();
}

Result<void> Renderer::Submit(const DrawList& list, const Camera& camera, const Overlay* overlay)
{
    static const Overlay kNothing;
    Impl& impl = *m_impl;
    const Overlay& top = overlay ? *overlay : kNothing;
    RETURN_IF_ERROR(CheckCamera(camera, impl.settings));
    RETURN_IF_ERROR(CheckOverlay(top));
    const std::size_t outside = impl.statistics.itemsOutside;
    impl.statistics = {};
    impl.statistics.items = list.items.size();
    if (impl.hasLast && impl.last.Equals(list, camera, top))
    {
        impl.statistics.itemsOutside = outside;
        impl.statistics.itemsReused = list.items.size();
        impl.statistics.unchanged = true;
        impl.Count();
        return {};
    }
    const auto lock = LockGl();
    RETURN_IF_ERROR(impl.context->MakeCurrent());
    const bool isWhole = !impl.hasLast || impl.last.camera != camera || impl.settings.redrawsWhole;
    impl.hasLast = false; // until the frame is complete
    impl.builder.SetCamera(camera);
    impl.dirty.Clear();
    if (isWhole)
    {
        impl.matches.assign(list.items.size(), kNoMatch);
        impl.Build(list);
        impl.dirty.AddAll();
    }
    else
    {
        MatchItems(impl.last.list, list, impl.matches);
        impl.Build(list);
        impl.FindDirty(top);
    }
    impl.statistics.unchanged = impl.dirty.IsEmpty();
    impl.rectangles.clear();
    if (!impl.statistics.unchanged)
    {
        impl.Plan();
        RETURN_IF_ERROR(impl.Draw(top));
    }
    impl.Keep(list, camera, top);
    impl.Count();
    return {};
}

Result<void> Renderer::Read(Frame& frame)
{
    Impl& impl = *m_impl;
    const auto lock = LockGl();
    RETURN_IF_ERROR(impl.context->MakeCurrent());
    const PixelBounds picture = impl.Picture();
    if (frame.width != picture.x1 || frame.height != picture.y1 ||
        frame.rgba.size() != std::size_t(picture.Area()) * 4)
    {
        frame = Frame(picture.x1, picture.y1);
    }
    return impl.canvas->Read({&picture, 1}, frame);
}

Result<const Frame*> Renderer::ReadChanges()
{
    Impl& impl = *m_impl;
    const auto lock = LockGl();
    RETURN_IF_ERROR(impl.context->MakeCurrent());
    if (impl.frame.rgba.empty())
    {
        impl.frame = Frame(impl.settings.width, impl.settings.height);
    }
    impl.unread.Gather(kReadGap, impl.changes);
    RETURN_IF_ERROR(impl.canvas->Read(impl.changes, impl.frame));
    impl.unread.Clear();
    return &impl.frame;
}

Result<void> Renderer::Show()
{
    const auto lock = LockGl();
    RETURN_IF_ERROR(m_impl->context->MakeCurrent());
    m_impl->canvas->CopyToScreen();
    m_impl->context->SwapBuffers();
    return {};
}

std::span<const PixelBounds> Renderer::Changes() const
{
    return m_impl->changes;
}

Result<void> Renderer::Draw(const DrawList& list, const Camera& camera, Frame& frame,
                            const Overlay* overlay)
{
    RETURN_IF_ERROR(Submit(list, camera, overlay));
    return Read(frame);
}

const RenderStatistics& Renderer::Statistics() const
{
    return m_impl->statistics;
}

const RenderTotals& Renderer::Totals() const
{
    return m_impl->totals;
}

const std::string& Renderer::Description() const
{
    return m_impl->description;
}

Result<std::string> Renderer::Fingerprint() const
{
    return ProbeFingerprint(m_impl->settings.backend, m_impl->description);
}

} // namespace boxreel
