// SPDX-License-Identifier: MIT
#pragma once

#include <render/Overlay.h>

#include <span>

/// Polygons and lines with soft edges as the triangles of an Overlay. Called by ImGuiDrawData. Uses
/// sums, products, quotients and square roots alone, which every processor rounds alike.
namespace boxreel
{

/// The nearest point whose coordinates are multiples of 1 / 256 px, the grid on which GL places
/// corners: nothing that is added later rounds it to another one.
Vec2 OnGrid(Vec2 pixel);

/// Appends a convex polygon, filled, whose edges fade over a pixel. `uv`: a white texel.
void AppendPolygon(std::span<const Vec2> corners, Color color, Vec2 uv, Overlay& overlay);

/// Appends a line of `width` [px], at least 1, whose sides fade over a pixel.
void AppendLine(std::span<const Vec2> points, bool closed, double width, Color color, Vec2 uv,
                Overlay& overlay);

} // namespace boxreel
