// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

/// @file
/// Arrows whose shaft is measured in metres and whose head in pixels, so that a head is as large
/// in every view.
namespace boxreel
{

/// How large an arrow's head is.
struct ArrowHead
{
    double length = 9.0;    ///< along the shaft [px]
    double halfWidth = 3.0; ///< across it [px]
    bool open = false;      ///< two strokes from the point, and a shaft that reaches it
};

/// A shaft from `tail` to `tip` [m] with a head, filled or open, whose point lies at `tip`; stamped
/// with the list's layer and owner. A shaft shorter than its head gets a smaller head. Nothing is
/// added when tail and tip are one point, or not finite.
void AddArrow(DrawList& list, const Camera& camera, Vec2 tail, Vec2 tip, const Paint& paint,
              const ArrowHead& head = {});

} // namespace boxreel
