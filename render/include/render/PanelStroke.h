// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <span>

struct ImDrawList;

/// @file
/// Lines on the panels of PanelCanvas. Dear ImGui computes the direction of a line with an estimate
/// that differs from one processor to the next: ask it only for horizontal and vertical lines, give
/// its borders no width, and draw every other line with these.
namespace boxreel
{

/// Adds a line with soft edges through `points` [px, y down], of `width` [px], at least 1; `closed`
/// joins its ends. Fewer than two points add nothing.
void AddStroke(ImDrawList& list, std::span<const Vec2> points, bool closed, double width,
               Color color);

/// Adds the border of a rectangle with round corners, drawn inside of it. All lengths in pixels.
void AddBorder(ImDrawList& list, const Rect& rectangle, float rounding, float width, Color color);

} // namespace boxreel
