// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <string>

/// @file
/// A DrawList as text that a person can review in a diff, one item per line. A line contains owner,
/// layer, kind, colour, points [m] and size:
/// `body 3 shapes solid-polygon #e6b3b3 (0, 0) (1, 0) (1, 1)`
/// Used as the second depth of golden tests. Numbers are printed with the fewest digits that read
/// back exactly. Two lists filled by the Add functions therefore have the same text exactly when
/// they are equal. Only the roles of colours are not in the text.
namespace boxreel
{

/// Returns one line per item, with exact numbers.
std::string ToText(const DrawList& list);

} // namespace boxreel
