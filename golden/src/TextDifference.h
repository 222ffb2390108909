// SPDX-License-Identifier: MIT
#pragma once

#include <golden/ReferenceStore.h>

#include <optional>
#include <string_view>

/// Where two texts part, line by line. Knows nothing of what the lines mean.
namespace boxreel
{

/// None when the texts are equal.
std::optional<LineDifference> FirstDifference(std::string_view expected, std::string_view actual);

} // namespace boxreel
