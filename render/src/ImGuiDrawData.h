// SPDX-License-Identifier: MIT
#pragma once

#include <render/Overlay.h>

struct ImDrawData;

/// Converts Dear ImGui's draw data to an Overlay that is the same on every processor. For
/// ImGui*.cpp only. Dear ImGui must draw without anti-aliasing: it places soft edges with an
/// estimate of a square root that differs between processors.
namespace boxreel
{

/// Replaces `overlay`: glyphs and axis-aligned rectangles unchanged, polygons and strokes with soft
/// edges. `width`, `height`: of the picture [px].
void CopyDrawData(const ImDrawData& data, int width, int height, Overlay& overlay);

} // namespace boxreel
