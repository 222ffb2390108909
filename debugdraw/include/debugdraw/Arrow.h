// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

/// @file
/// Arrows with a shaft in metres and a head in pixels, so that heads have the same size in every
/// view.
namespace boxreel
{

/// The size and style of an arrow's head.
struct ArrowHead
{
    double length = 9.0;    ///< along the shaft [px]
    double halfWidth = 3.0; ///< perpendicular to the shaft [px]
    bool open = false;      ///< two strokes instead of a triangle; the shaft reaches the tip
};

/// Adds a shaft from `tail` to `tip` [m] with a filled or open head that points to `tip`. It gets
/// the list's layer and owner. A shaft shorter than its head gets a smaller head. Adds nothing if
/// tail and tip are equal, or not finite.
void AddArrow(DrawList& list, const Camera& camera, Vec2 tail, Vec2 tip, const Paint& paint,
              const ArrowHead& head = {});

} // namespace boxreel
