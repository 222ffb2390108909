// SPDX-License-Identifier: MIT
#pragma once

#include <render/Overlay.h>

struct ImDrawData;

/// What Dear ImGui draws, as an Overlay that is the same on every processor. For ImGui*.cpp alone.
/// Dear ImGui must draw without anti-aliasing: its own soft edges are placed by an estimate of a
/// square root that differs between processors.
namespace boxreel
{

/// Replaces `overlay`: letters and upright rectangles as they are, polygons and strokes with soft
/// edges. `width`, `height`: of the picture [px].
void CopyDrawData(const ImDrawData& data, int width, int height, Overlay& overlay);

} // namespace boxreel
