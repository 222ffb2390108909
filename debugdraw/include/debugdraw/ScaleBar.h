// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

/// @file
/// How long a metre is in a picture: a bar of a nice length, with that length.
namespace boxreel
{

/// What the bar needs from its upper end [px].
inline constexpr int kScaleBarHeight = 26;

/// A bar with its length beside it, drawn into a list that `paper` looks at, for a picture of
/// `pixelsPerMeter`. Its left end is at `left` [px of paper], the middle of its height too; bar and
/// text together are at most `room` wide [px], the bar a fifth to a half of that. In the layer
/// Annotations. Nothing where the scale is not finite or not above zero.
void AddScaleBar(DrawList& list, const Camera& paper, double pixelsPerMeter, Vec2 left,
                 double room);

} // namespace boxreel
