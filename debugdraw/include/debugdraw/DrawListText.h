// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <string>

/// @file
/// A DrawList as text that a person can review in a diff: one item a line, its owner, layer, kind,
/// colour, points [m] and size, e.g. `body 3 shapes solid-polygon #e6b3b3 (0, 0) (1, 0) (1, 1)`.
/// Used as the second depth of golden tests. Two lists filled by the Add functions have the same
/// text exactly when they are equal (numbers are printed with the fewest digits that read back),
/// but for the roles of colours, which are not in it.
namespace boxreel
{

/// Returns one line per item, with exact numbers.
std::string ToText(const DrawList& list);

} // namespace boxreel
