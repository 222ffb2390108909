// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <span>

/// @file
/// The path of a point as a line: the caller samples the centre of a body, or any other point, in
/// every step. Add it to the list below the shapes and above their earlier poses.
namespace boxreel
{

/// The style of a trail.
struct TrailSettings
{
    Paint color = ColorRole::Pair; ///< of the line
    double oldest = 0.35; ///< the opacity where it begins; 1 where it ends. 1: it does not fade
};

/// Adds the path, oldest point first [m], with the list's owner, in the layer Trails. Points
/// without a visible effect in the camera's picture are skipped, and so is a path that stays within
/// two pixels. A point that is not finite interrupts the path.
void AddTrail(DrawList& list, const Camera& camera, std::span<const Vec2> way,
              const TrailSettings& settings = {});

/// Returns the colour of the nth trail; distinguishable in every theme.
Paint TrailColor(std::size_t n);

} // namespace boxreel
