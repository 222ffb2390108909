// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

/// @file
/// A scale bar: a bar of a round length, labelled with it.
namespace boxreel
{

/// Height of the bar and its text [px].
inline constexpr int kScaleBarHeight = 26;

/// Adds a bar with its length beside it to a list with the camera `paper`, for a picture of
/// `pixelsPerMeter`. `left` is the centre of its left end [px of paper]. Bar and text are at most
/// `room` wide [px], the bar a fifth to a half of that. In the layer Annotations. Adds nothing if
/// the scale is not finite or not above zero.
void AddScaleBar(DrawList& list, const Camera& paper, double pixelsPerMeter, Vec2 left,
                 double room);

} // namespace boxreel
