// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <vector>

/// @file
/// Axes with ticks and numbers in metres, beside a picture, where they hide nothing of it. Drawn
/// into a list that `paper` looks at; the picture is what `view` shows, its top left corner at
/// `corner` [px of paper]. A Figure's panels are such pictures.
namespace boxreel
{

/// What the axes need beside the picture [px].
inline constexpr int kAxisBelow = 26;
inline constexpr int kAxisOver = 12; ///< beyond its right and upper ends
int RoomForAxis(const Camera& view); ///< on the left, where numbers lie beside each other

/// A line along the left and the lower edge, ticks at nice steps (1, 2, 5 times a power of ten)
/// and their numbers in the middle of them, the last that has room for it with the unit; in the
/// layer Annotations. Nothing for a view that has no finite scale above zero, or lies too far out
/// for its numbers to differ.
void AddAxes(DrawList& list, const Camera& paper, const Camera& view, Vec2 corner);

/// A cross with a circle at the world's origin, for a list that `view` looks at.
void AddOriginMark(DrawList& list, const Camera& view);

/// The multiples of `step` from `lower` to `upper`, all in metres.
std::vector<double> Ticks(double lower, double upper, double step);

} // namespace boxreel
