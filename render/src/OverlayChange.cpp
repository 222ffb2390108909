// SPDX-License-Identifier: MIT
#include "OverlayChange.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

/// Returns the pixels that a triangle can touch, within `clip`.
PixelBounds BoundsOf(const Overlay& overlay, std::size_t firstIndex, const PixelBounds& clip)
{
    Vec2 lower{float(clip.x1), float(clip.y1)};
    Vec2 upper{float(clip.x0), float(clip.y0)};
    for (std::size_t i = firstIndex; i < firstIndex + 3; ++i)
    {
        const Vec2 p = overlay.vertices[overlay.indices[i]].position;
        if (!std::isfinite(p.x) || !std::isfinite(p.y))
        {
            return clip;
        }
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    const auto whole = [](float value, int minimum, int maximum) {
        return int(std::clamp(value, float(minimum), float(maximum)));
    };
    // Positions are rounded to subpixels in the pipeline: one pixel of margin on every side.
    return {whole(std::floor(lower.x) - 1.0f, clip.x0, clip.x1),
            whole(std::floor(lower.y) - 1.0f, clip.y0, clip.y1),
            whole(std::ceil(upper.x) + 1.0f, clip.x0, clip.x1),
            whole(std::ceil(upper.y) + 1.0f, clip.y0, clip.y1)};
}

PixelBounds ClipOf(const OverlayCommand& command, const PixelBounds& picture)
{
    return Intersection({command.clipX0, command.clipY0, command.clipX1, command.clipY1}, picture);
}

/// Calls `see(first index, clip)` for every triangle of a command that is drawn.
template <class See>
void ForEachTriangle(const Overlay& overlay, const PixelBounds& picture, const See& see)
{
    for (const OverlayCommand& command : overlay.commands)
    {
        const PixelBounds clip = ClipOf(command, picture);
        for (std::size_t i = 0; !clip.IsEmpty() && i + 2 < command.indexCount; i += 3)
        {
            see(command.firstIndex + i, clip);
        }
    }
}

} // namespace

void AddDifference(const Overlay& last, const Overlay& next, int width, int height,
                   DirtyTiles& dirty)
{
    const PixelBounds picture{0, 0, width, height};
    const bool isSameForm = last.commands == next.commands && last.indices == next.indices &&
                            last.vertices.size() == next.vertices.size();
    const auto addAll = [&](const Overlay& overlay) {
        ForEachTriangle(overlay, picture, [&](std::size_t first, const PixelBounds& clip) {
            dirty.Add(BoundsOf(overlay, first, clip));
        });
    };
    if (!isSameForm)
    {
        addAll(last);
        addAll(next);
        return;
    }
    ForEachTriangle(next, picture, [&](std::size_t first, const PixelBounds& clip) {
        const auto isSame = [&](std::uint32_t vertex) {
            return last.vertices[vertex] == next.vertices[vertex];
        };
        if (!std::all_of(next.indices.begin() + std::ptrdiff_t(first),
                         next.indices.begin() + std::ptrdiff_t(first + 3), isSame))
        {
            dirty.Add(BoundsOf(last, first, clip));
            dirty.Add(BoundsOf(next, first, clip));
        }
    });
}

} // namespace boxreel
