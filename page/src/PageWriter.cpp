// SPDX-License-Identifier: MIT
#include "PageHead.h"
#include <page/PageWriter.h>

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Words.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

namespace boxreel
{
namespace
{

constexpr int kMaxSide = 8192;      // [px], as renderers and films
constexpr double kMaxRate = 1000.0; // [frames/s], as films

Result<void> Check(const PageSettings& settings)
{
    if (settings.width < 1 || settings.height < 1 || settings.width > kMaxSide ||
        settings.height > kMaxSide)
    {
        return Error{
            ErrorKind::Unusable,
            ErrorSetting{BOXREEL_MEMBERS(PageSettings, width, height),
                         {std::to_string(settings.width), std::to_string(settings.height)}},
            "width and height must be between 1 and " + std::to_string(kMaxSide)};
    }
    const auto isAbove0 = [](double value) { return std::isfinite(value) && value > 0.0; };
    if (!isAbove0(settings.framesPerSecond) || settings.framesPerSecond > kMaxRate)
    {
        return Error{ErrorKind::Unusable,
                     ErrorSetting{BOXREEL_MEMBER(PageSettings, framesPerSecond),
                                  {NumberText(settings.framesPerSecond)}},
                     "must be above 0 and at most 1000 frames per second"};
    }
    if (!isAbove0(settings.speed) || !std::isfinite(settings.firstTime))
    {
        return Error{ErrorKind::Unusable, "time of the page",
                     "must have a speed above 0 and a finite first time",
                     "set speed and firstTime"};
    }
    return {};
}

bool IsGlyph(const DrawItem& item)
{
    return item.layer == DrawLayer::JointGlyphs;
}

/// Returns a list whose glyphs have the anchors of their points behind these. Circles and points do
/// not need them, because they are about their own centre.
DrawList WithAnchors(const DrawList& list, std::span<const Vec2> anchors)
{
    std::size_t count = 0;
    for (const DrawItem& item : list.items)
    {
        count += IsGlyph(item) ? item.count : 0;
    }
    const bool isUsable = anchors.size() == count;
    DrawList anchored = list;
    std::size_t at = 0; // in anchors
    for (DrawItem& item : anchored.items)
    {
        if (!IsGlyph(item))
        {
            continue;
        }
        const std::size_t first = item.first;
        const std::size_t points = item.count;
        if (item.kind != DrawKind::Circle && item.kind != DrawKind::Point)
        {
            item.first = std::uint32_t(anchored.points.size());
            item.count = std::uint16_t(2 * points);
            const auto own = list.points.begin() + std::ptrdiff_t(first);
            anchored.points.insert(anchored.points.end(), own, own + std::ptrdiff_t(points));
            const auto from = isUsable ? anchors.subspan(at, points)
                                       : std::span(list.points).subspan(first, points);
            anchored.points.insert(anchored.points.end(), from.begin(), from.end());
        }
        at += points;
    }
    return anchored;
}

} // namespace

struct PageWriter::Impl
{
    Impl(AtomicFile&& opened, const PageSettings& asked) : file(std::move(opened)), settings(asked)
    {}

    Result<void> Write(const std::string& text)
    {
        return file.Write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }
    Result<void> WriteGroup()
    {
        const std::int64_t frames = encoder->FramesInGroup();
        ASSIGN_OR_RETURN(const std::string group, PageGroup(encoder->TakeGroup(), frames));
        return Write(group);
    }
    Result<void> WriteRest();

    AtomicFile file;
    PageSettings settings;
    std::optional<PageEncoder> encoder; // from the first frame on
    PageFacts facts;
};

Result<void> PageWriter::Impl::WriteRest()
{
    if (facts.frames == 0)
    {
        return Error{ErrorKind::Unusable, "page", "has no frame",
                     "append at least one before Close"};
    }
    if (encoder->FramesInGroup() > 0)
    {
        RETURN_IF_ERROR(WriteGroup());
    }
    ASSIGN_OR_RETURN(const std::string end, PageEnd(settings, *encoder, facts));
    return Write(end);
}

PageWriter::PageWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
PageWriter::PageWriter(PageWriter&&) noexcept = default;
PageWriter& PageWriter::operator=(PageWriter&&) noexcept = default;
PageWriter::~PageWriter() = default;

Result<void> CheckPagePath(const std::filesystem::path& path, const PageSettings& settings)
{
    if (Lower(path.extension().string()) != ".html")
    {
        return Error{ErrorKind::Unusable, path.string(), "is not the name of a page",
                     "end it in .html"};
    }
    return Check(settings);
}

Result<PageWriter> PageWriter::Open(const std::filesystem::path& path, const PageSettings& settings)
{
    RETURN_IF_ERROR(CheckPagePath(path, settings));
    const ErrorSetting overwritten{BOXREEL_MEMBER(PageSettings, overwrite), {"true"}};
    ASSIGN_OR_RETURN(AtomicFile file,
                     AtomicFile::Create(path, {.overwrite = settings.overwrite,
                                               .replacesLeftover = settings.overwrite,
                                               .leftoverRemedy = "start again (" + overwritten +
                                                                 ") or choose another name"}));
    auto impl = std::make_unique<Impl>(std::move(file), settings);
    RETURN_IF_ERROR(impl->Write(PageBegin(settings)));
    return PageWriter(std::move(impl));
}

Result<void> PageWriter::Append(const DrawList& list, const Camera& camera,
                                std::span<const PageBody> bodies,
                                std::span<const Vec2> glyphAnchors)
{
    assert(m_impl && "nothing can be appended after Close");
    const PageSettings& settings = m_impl->settings;
    if (camera.width != settings.width || camera.height != settings.height)
    {
        return Error{ErrorKind::Unusable, "camera", "size differs from that of the page",
                     "give each frame a camera of the page's width and height"};
    }
    const bool isDrawable = CanBeDrawn(camera);
    if (isDrawable && !m_impl->encoder)
    {
        m_impl->encoder.emplace(camera, settings.framesPerSecond / settings.speed);
    }
    if (!isDrawable || !m_impl->encoder->CanHold(camera))
    {
        return Error{ErrorKind::Unusable, "camera",
                     "view is too far from the origin for its scale, or not finite",
                     "zoom out or move the view"};
    }
    PageEncoder& encoder = *m_impl->encoder;
    if (camera.pixelsPerMeter > encoder.FullScale())
    {
        return Error{ErrorKind::Unusable, "camera",
                     "zooms in to more than " + std::to_string(int(kPageZoom)) +
                         " times the scale of the first frame, which is the largest zoom of a page",
                     "begin nearer or zoom in less"};
    }
    const bool hasGlyphs = std::any_of(list.items.begin(), list.items.end(), IsGlyph);
    encoder.Add(hasGlyphs ? WithAnchors(list, glyphAnchors) : list, camera, bodies);
    ++m_impl->facts.frames;
    for (const PageBody& body : bodies)
    {
        if (!body.name.empty())
        {
            m_impl->facts.names.insert_or_assign(body.number, body.name);
        }
    }
    return encoder.IsGroupFull() ? m_impl->WriteGroup() : Result<void>();
}

Result<void> PageWriter::Close()
{
    assert(m_impl && "a page is closed once");
    const std::unique_ptr<Impl> impl = std::move(m_impl);
    RETURN_IF_ERROR(impl->WriteRest());
    return impl->file.Commit();
}

Result<void> PageWriter::Suspend()
{
    assert(m_impl && "a page is closed once");
    const std::unique_ptr<Impl> impl = std::move(m_impl);
    RETURN_IF_ERROR(impl->WriteRest());
    return impl->file.Leave();
}

} // namespace boxreel
