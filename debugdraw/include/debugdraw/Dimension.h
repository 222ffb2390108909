// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <string>

/// @file
/// Measures in a picture, as technical drawings have them: two extension lines, a line with arrows
/// between them, and the distance.
namespace boxreel
{

/// How a dimension is drawn, and what it says.
struct DimensionSettings
{
    double offset = 30.0; ///< of the measured points from the line with the arrows, on the side
                          ///< where there is room: above, else below; left, else right; the
                          ///< other way round when it is negative [px]
    std::string label;    ///< empty: the distance, such as "1.25 m"
    Paint color = ColorRole::Ink; ///< of lines and label
};

/// The distance between `a` and `b` [m], for a list that `view` looks at. Where the arrows do not
/// fit between the extension lines they point at them from outside. The text stays in the picture
/// when the arrows do; where the list has an outline, a sign or a text there, it moves along the
/// line, or to its other side, if it is clear of them there. In the layer Annotations. Nothing is
/// added when the points are one, or not finite.
void AddDimension(DrawList& list, const Camera& view, Vec2 a, Vec2 b,
                  const DimensionSettings& settings = {});

} // namespace boxreel
