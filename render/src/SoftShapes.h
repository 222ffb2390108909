// SPDX-License-Identifier: MIT
#pragma once

#include <render/Overlay.h>

#include <span>

/// Converts polygons and lines with soft edges to triangles of an Overlay. Called by ImGuiDrawData.
/// Uses only sums, products, quotients and square roots, which every processor rounds equally.
namespace boxreel
{

/// Rounds to multiples of 1 / 256 px, the vertex grid of GL, so that later rounding does not change
/// the point.
Vec2 OnGrid(Vec2 pixel);

/// Appends a filled convex polygon whose edges fade over one pixel. `uv`: a white texel.
void AppendPolygon(std::span<const Vec2> corners, Color color, Vec2 uv, Overlay& overlay);

/// Appends a line of `width` [px], at least 1, whose sides fade over one pixel.
void AppendLine(std::span<const Vec2> points, bool closed, double width, Color color, Vec2 uv,
                Overlay& overlay);

} // namespace boxreel
