// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

#include <map>
#include <string>

/// @file
/// What marks a body or a joint: its name, its centre of mass. Only reads the world. With a view, a
/// body at rest that has nothing in the picture is not looked at.
namespace boxreel
{

/// What bodies are called, by their number in the order of creation.
using BodyNames = std::map<std::uint32_t, std::string>;

/// What joints are called. A scene that destroys a joint takes its name out.
using JointNames = std::map<const b2Joint*, std::string>;

/// The name of each body, or its number where it has none, centred on its centre of mass; where the
/// list has a sign, a note, a label or another body's shape there, beside it, with a thin line from
/// the centre when it is not on its body. So call it after all that should be in the way. Wholly in
/// the picture; no name where the centre is not in it, nor in a crowd where it would lie on another
/// body's centre or label.
void AddBodyNames(const b2World& world, const View& view, const BodyNames& names, DrawList& list);

/// The names of those joints that have one, between their anchors, and out of the way likewise,
/// with a line only from far away.
void AddJointNames(const b2World& world, const View& view, const JointNames& names, DrawList& list);

/// The sign of a centre of mass, a disc of 12 pixels in four quarters, on every body with a mass.
void AddCenterMarks(const b2World& world, const View& view, DrawList& list);

} // namespace boxreel
