// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <string>

/// @file
/// A DrawList as text for diffs: one item per line with owner, layer, kind, colour, points [m] and
/// size, e.g. `body 3 shapes solid-polygon #e6b3b3 (0, 0) (1, 0) (1, 1)`. The second depth of
/// golden tests. Two lists filled by the Add functions have the same text exactly if they are
/// equal; numbers have the fewest digits that read back exactly.
namespace boxreel
{

/// Returns one line per item, with exact numbers.
std::string ToText(const DrawList& list);

/// Returns the name in that text: "shapes", "joints", …
const char* LayerName(DrawLayer layer);

} // namespace boxreel
