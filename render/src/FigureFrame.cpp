// SPDX-License-Identifier: MIT
#include <render/FigureFrame.h>

#include "FigureCanvas.h"
#include "FigureLetters.h"
#include "FontAtlas.h"

#include <base/ErrorMacros.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace boxreel
{
namespace
{

constexpr int kMaxPixels = 8192; // per side, as in Renderer

/// The position of a panel in the figure's frame, and its visible part [px]; upper bounds excluded.
struct Placed
{
    int x, y; ///< corner of the panel, may lie outside
    int left, top, right, bottom;
};

Placed PlaceOf(const FigurePanel& panel, const Camera& camera, const Figure& figure,
               const Frame& frame)
{
    // Clamped before the conversion to integers, to avoid overflow.
    const auto pixel = [&figure](double place) {
        return static_cast<int>(std::floor(std::clamp(place * figure.scale, -1e6, 1e6) + 0.5));
    };
    const int x = pixel(panel.x);
    const int y = pixel(panel.y);
    return {x,
            y,
            std::clamp(x, 0, frame.width),
            std::clamp(y, 0, frame.height),
            std::clamp(x + camera.width, 0, frame.width),
            std::clamp(y + camera.height, 0, frame.height)};
}

Frame Ground(int width, int height, Color color)
{
    Frame frame(width, height);
    const auto premultiplied = [&color](std::uint8_t channel) {
        return static_cast<std::uint8_t>((channel * color.a + 127) / 255);
    };
    for (std::size_t i = 0; i < frame.rgba.size(); i += 4)
    {
        frame.rgba[i] = premultiplied(color.r);
        frame.rgba[i + 1] = premultiplied(color.g);
        frame.rgba[i + 2] = premultiplied(color.b);
        frame.rgba[i + 3] = color.a;
    }
    return frame;
}

bool IsGround(const Frame& frame, const Frame& ground, const Placed& at)
{
    for (int y = at.top; y < at.bottom && at.left < at.right; ++y)
    {
        if (!std::equal(frame.Pixel(at.left, y), frame.Pixel(at.right - 1, y) + 4,
                        ground.Pixel(at.left, y)))
        {
            return false;
        }
    }
    return true;
}

void CopyInto(Frame& frame, const Frame& panel, const Placed& at)
{
    for (int y = at.top; y < at.bottom && at.left < at.right; ++y)
    {
        const std::uint8_t* const from = panel.Pixel(at.left - at.x, y - at.y);
        std::copy(from, from + 4 * (at.right - at.left), frame.Pixel(at.left, y));
    }
}

/// "Over" for premultiplied pixels (Porter and Duff, 1984).
void BlendInto(Frame& frame, const Frame& panel, const Placed& at)
{
    for (int y = at.top; y < at.bottom; ++y)
    {
        for (int x = at.left; x < at.right; ++x)
        {
            const std::uint8_t* const top = panel.Pixel(x - at.x, y - at.y);
            std::uint8_t* const below = frame.Pixel(x, y);
            for (int c = 0; c < 4; ++c)
            {
                const int seen = top[c] + (below[c] * (255 - top[3]) + 127) / 255;
                below[c] = static_cast<std::uint8_t>(std::min(seen, 255));
            }
        }
    }
}

/// Renderers for each size of panel, created once, with the theme's background or a transparent
/// one.
class Renderers
{
public:
    Renderers(const Figure& figure, Backend backend) : m_figure(figure), m_backend(backend) {}

    Result<Frame> Draw(const DrawList& list, const Camera& camera, bool onGround)
    {
        const std::tuple key{camera.width, camera.height, onGround};
        auto found = m_renderers.find(key);
        if (found == m_renderers.end())
        {
            RendererSettings settings{.width = camera.width,
                                      .height = camera.height,
                                      .theme = m_figure.theme,
                                      .backend = m_backend,
                                      .scale = m_figure.scale};
            settings.theme.background = onGround ? m_figure.theme.background : Color{0, 0, 0, 0};
            ASSIGN_OR_RETURN(Renderer made, Renderer::Create(settings));
            found = m_renderers.emplace(key, std::move(made)).first;
        }
        Frame frame;
        const Result<void> drawn = found->second.Draw(list, camera, frame);
        return drawn ? Result<Frame>(std::move(frame)) : drawn.GetError();
    }

    RenderTotals Totals() const
    {
        RenderTotals sum;
        for (const auto& [key, renderer] : m_renderers)
        {
            sum += renderer.Totals();
        }
        return sum;
    }

private:
    const Figure& m_figure;
    Backend m_backend;
    std::map<std::tuple<int, int, bool>, Renderer> m_renderers;
};

} // namespace

Result<Frame> ToFrame(const Figure& figure, Backend backend, RenderTotals* totals)
{
    RETURN_IF_ERROR(CheckFigure(figure));
    const Camera size =
        Scaled(Camera{.width = figure.width, .height = figure.height}, figure.scale);
    if (std::max(size.width, size.height) > kMaxPixels)
    {
        return Error{ErrorKind::Unusable,
                     "size " + std::to_string(size.width) + "x" + std::to_string(size.height),
                     "a figure must be at most 8192 pixels wide and high",
                     "choose a smaller scale or size"};
    }
    const Frame ground = Ground(size.width, size.height, figure.theme.background);
    Frame frame = ground;
    Renderers renderers(figure, backend);
    for (const FigurePanel& panel : figure.panels)
    {
        const Camera camera = Scaled(panel.camera, figure.scale);
        const Placed at = PlaceOf(panel, camera, figure, frame);
        const bool onGround = IsGround(frame, ground, at);
        ASSIGN_OR_RETURN(const Frame drawn, renderers.Draw(panel.list, camera, onGround));
        (onGround ? CopyInto : BlendInto)(frame, drawn, at);
    }
    if (totals != nullptr)
    {
        *totals = renderers.Totals();
    }
    return frame;
}

std::vector<std::string> LettersWithoutPixels(const Figure& figure)
{
    return LettersWithout(figure, [](char32_t code) { return FontAtlas::Get().Has(code); });
}

Result<void> PrepareFrames(Backend backend)
{
    const Result<Renderer> renderer =
        Renderer::Create({.width = 1, .height = 1, .backend = backend});
    return renderer ? Result<void>() : renderer.GetError();
}

} // namespace boxreel
