// SPDX-License-Identifier: MIT
#pragma once

#include "DifferencePicture.h"

#include <golden/Compare.h>

/// Marks every pixel of two pictures: the larger part of Compare's work and time.
namespace boxreel
{

/// Returns a mark for every pixel of the larger size. Sets the counts, the largest distance and the
/// first pixel over the tolerance in `result`.
Marks MarkDifferences(const Frame& expected, const Frame& actual, const CompareSettings& settings,
                      Comparison& result);

} // namespace boxreel
