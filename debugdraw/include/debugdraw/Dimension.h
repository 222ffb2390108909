// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <string>

/// @file
/// Dimensions as in technical drawings: two extension lines, a line with arrows between them, and
/// the distance.
namespace boxreel
{

/// Style and label of a dimension.
struct DimensionSettings
{
    double offset = 30.0; ///< from the measured points to the line with the arrows [px]. Positive:
                          ///< above or left if there is space; negative: the opposite side
    std::string label;    ///< empty: the distance, such as "1.25 m"
    Paint color = ColorRole::Ink; ///< of lines and label
};

/// Adds the distance between `a` and `b` [m] to a list with the camera `view`, in the layer
/// Annotations. If the arrows do not fit between the extension lines, they point from outside. The
/// text stays in the picture if the arrows do. It moves along the line, or to the other side, if
/// that avoids outlines, glyphs and texts of the list. Adds nothing when the points are equal or
/// not finite.
void AddDimension(DrawList& list, const Camera& view, Vec2 a, Vec2 b,
                  const DimensionSettings& settings = {});

} // namespace boxreel
