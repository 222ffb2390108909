// SPDX-License-Identifier: MIT
#pragma once

#include "DifferencePicture.h"

#include <golden/Compare.h>

/// Judges every pixel of two pictures. The larger part of what Compare does, and of its time.
namespace boxreel
{

/// One mark for every pixel of the larger size. Counts into `result`, which has the largest
/// distance and the first pixel over the tolerance then, too.
Marks MarkDifferences(const Frame& expected, const Frame& actual, const CompareSettings& settings,
                      Comparison& result);

} // namespace boxreel
