// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

#include <map>
#include <string>

/// @file
/// Names and centres of mass of bodies, and names of joints. Only reads the world. With a view,
/// bodies at rest outside the picture are not visited.
namespace boxreel
{

/// Names of bodies, by their number in creation order.
using BodyNames = std::map<std::uint32_t, std::string>;

/// Names of joints. A scene that destroys a joint removes its name.
using JointNames = std::map<const b2Joint*, std::string>;

/// Adds the name of each body, or its number, centred on its centre of mass. If a glyph, note,
/// label or other body's shape is there, the name is placed beside it. A thin line connects a name
/// outside its body. Call this after adding those items. Labels are completely inside the picture.
/// A body has none if its centre is outside, or if there is no space free of other centres and
/// labels. With a zoom above 1 (View::zoom), the viewer does all that.
void AddBodyNames(const b2World& world, const View& view, const BodyNames& names, DrawList& list);

/// Adds the names of joints, between their anchors, placed as above, with a line only from a
/// distance.
void AddJointNames(const b2World& world, const View& view, const JointNames& names, DrawList& list);

/// Adds a centre of mass glyph, a disc of 12 pixels in four quarters, to every body with a mass.
void AddCenterMarks(const b2World& world, const View& view, DrawList& list);

} // namespace boxreel
