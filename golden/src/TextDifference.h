// SPDX-License-Identifier: MIT
#pragma once

#include <golden/ReferenceStore.h>

#include <optional>
#include <string_view>

/// Finds the first difference of two texts, line by line. Does not interpret the lines.
namespace boxreel
{

/// None when the texts are equal.
std::optional<LineDifference> FirstDifference(std::string_view expected, std::string_view actual);

} // namespace boxreel
