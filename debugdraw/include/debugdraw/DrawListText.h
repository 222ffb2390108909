// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <string>

/// A DrawList as text that a person can review in a diff: one item a line, its owner, layer, kind,
/// colour and points. Used as the second depth of golden tests. Two lists have the same text
/// exactly when they are equal (numbers are printed with the fewest digits that read back).
namespace boxreel
{

std::string ToText(const DrawList& list);

} // namespace boxreel
