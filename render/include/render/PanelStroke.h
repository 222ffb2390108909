// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <span>

struct ImDrawList;

/// @file
/// Lines on the panels of PanelCanvas. Dear ImGui estimates the direction of a line, with results
/// that differ between processors. Use it only for horizontal and vertical lines and for borders
/// without width; draw all other lines with these functions.
namespace boxreel
{

/// Adds an antialiased line through `points` [px, y down], of `width` [px], at least 1. `closed`
/// connects the ends. Fewer than two points add nothing.
void AddStroke(ImDrawList& list, std::span<const Vec2> points, bool closed, double width,
               Color color);

/// Adds the border of a rectangle with rounded corners, inside of it. All lengths in pixels.
void AddBorder(ImDrawList& list, const Rect& rectangle, float rounding, float width, Color color);

} // namespace boxreel
