// SPDX-License-Identifier: MIT
#pragma once

#include "DirtyTiles.h"

#include <render/Overlay.h>

/// Finds the pixels that differ between two overlays. Called by Renderer.
namespace boxreel
{

/// Adds to `dirty` all pixels that may differ. `width`, `height`: of the picture [px].
void AddDifference(const Overlay& last, const Overlay& next, int width, int height,
                   DirtyTiles& dirty);

} // namespace boxreel
