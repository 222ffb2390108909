// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

#include <vector>

/// @file
/// Joints of a world as the glyphs of mechanism diagrams: type, position and degrees of freedom.
/// Their size is in pixels, so that they are legible at any zoom. Lengths in the world (springs,
/// ropes, rails with limits) are to scale.
namespace boxreel
{

/// | type      | glyph                                                              |
/// | --------- | ------------------------------------------------------------------ |
/// | revolute  | a circle with a dot; an arrow around it shows a motor's direction  |
/// | prismatic | a rail along the axis, up to its limits, and a carriage;           |
/// |           | an arrow beside it shows a motor's direction                       |
/// | distance  | a bar with two pins, or a spring when it is soft                   |
/// | pulley    | two wheels and the rope                                            |
/// | gear      | two toothed wheels, around the hinges or carriages, and a dashed   |
/// |           | line between them                                                  |
/// | wheel     | an axle, and the spring above it; an arrow as with revolute        |
/// | weld      | a filled square with a cross                                       |
/// | rope      | a dashed line that sags until it is taut, with its maximum length  |
/// | friction  | a disc between two pads                                            |
/// | mouse     | cross-hairs at the target, and a dashed line from there            |
/// | motor     | an arrow around the second body's origin, dashed to the first's    |
///
/// Oldest joint first.
void AddJointGlyphs(const b2World& world, const View& view, DrawList& list);

/// Returns the anchor of each point that AddJointGlyphs adds for this view: where the point is when
/// pixels are infinitely small [m]. What lies between is in pixels, so that a viewer can enlarge
/// the picture by up to `zoom`, above 1, and keep the size of glyphs. Tangents of pulleys are exact
/// at both ends only.
std::vector<Vec2> JointGlyphAnchors(const b2World& world, const View& view, double zoom);

} // namespace boxreel
