// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <vector>

/// @file
/// Axes with ticks and numbers in metres, outside a picture. They are drawn into a list with the
/// camera `paper`. The picture shows `view`, with its top left corner at `corner` [px of paper]; a
/// Figure's panels are such pictures.
namespace boxreel
{

/// Space of the axes below the picture [px].
inline constexpr int kAxisBelow = 26;
inline constexpr int kAxisOver = 12; ///< beyond its right and upper edges
int RoomForAxis(const Camera& view); ///< on the left, wide enough for the numbers

/// Adds a line along the left and the lower edge, with ticks at 1, 2 or 5 times a power of ten.
/// Numbers are centred on the ticks; the last that fits has the unit. In the layer Annotations.
/// Adds nothing for a view without a finite scale above zero, or so far out that its numbers are
/// equal.
void AddAxes(DrawList& list, const Camera& paper, const Camera& view, Vec2 corner);

/// Adds a cross with a circle at the world's origin, to a list with the camera `view`.
void AddOriginMark(DrawList& list, const Camera& view);

/// Returns the multiples of `step` from `lower` to `upper`, all in metres.
std::vector<double> Ticks(double lower, double upper, double step);

} // namespace boxreel
