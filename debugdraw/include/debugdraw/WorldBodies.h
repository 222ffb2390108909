// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

#include <map>
#include <string>

/// What marks a body: its name, its centre of mass. Only reads the world.
namespace boxreel
{

/// What bodies are called, by their number in the order of creation.
using BodyNames = std::map<std::uint32_t, std::string>;

/// The name of each body, or its number where it has none, centred on its centre of mass.
void AddBodyNames(const b2World& world, const View& view, const BodyNames& names, DrawList& list);

/// The sign of a centre of mass, a disc of 12 pixels in four quarters, on every body with a mass.
void AddCenterMarks(const b2World& world, const View& view, DrawList& list);

} // namespace boxreel
