// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

/// @file
/// The signs by which mechanisms are drawn in books, for the joints of a world: what kind each is,
/// where it is, which way it gives. Their size is in pixels, so that they read at any zoom; what
/// has a length in the world (springs, ropes, rails with limits) has it in the picture.
namespace boxreel
{

/// | kind      | sign                                                               |
/// | --------- | ------------------------------------------------------------------ |
/// | revolute  | a circle with a dot; an arrow around it that says how a motor turns |
/// | prismatic | a rail along the axis, to its limits if it has them, and a carriage; |
/// |           | an arrow beside it that says how a motor drives                    |
/// | distance  | a bar with two pins, or a spring when it is soft                   |
/// | pulley    | two wheels and the rope                                            |
/// | gear      | two toothed wheels, around the hinges or carriages, and a dashed   |
/// |           | line between them                                                  |
/// | wheel     | an axle, and the spring above it; an arrow as with revolute         |
/// | weld      | a filled square with a cross                                       |
/// | rope      | a dashed line that sags until it is taut, with its greatest length |
/// | friction  | a disc between two pads                                            |
/// | mouse     | cross-hairs at the target, a dashed line from there                |
/// | motor     | an arrow around the second body's origin, dashed to the first's    |
///
/// Oldest joint first.
void AddJointGlyphs(const b2World& world, const View& view, DrawList& list);

} // namespace boxreel
