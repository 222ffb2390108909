// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <span>

/// @file
/// The way that a point has gone, as a line: the caller samples it step by step, the centre of a
/// body or any other point. Reads best beneath the shapes and above their earlier
/// poses: add it to the list between them.
namespace boxreel
{

/// How a trail looks.
struct TrailSettings
{
    Paint color = ColorRole::Pair; ///< of the line
    double oldest = 0.35; ///< the opacity where it begins; 1 where it ends. 1: it does not fade
};

/// Adds the way, oldest point first [m], stamped with the list's owner, in the layer Trails. Of the
/// points those are left out that change nothing in the camera's picture, and all of a way that
/// stays within two pixels. Where a point is not finite the way is interrupted.
void AddTrail(DrawList& list, const Camera& camera, std::span<const Vec2> way,
              const TrailSettings& settings = {});

/// Colours that can be told apart, in every theme: the nth trail's.
Paint TrailColor(std::size_t n);

} // namespace boxreel
