// SPDX-License-Identifier: MIT
#pragma once

#include "DifferencePicture.h"

#include <cstdint>

/// Measures whether differences are scattered or clustered. Called by Compare when all pixels are
/// marked. Tested by CompareTest, CompareWindows.
namespace boxreel
{

/// Returns the maximum number of marks over the tolerance in any window of size x size pixels. size
/// >= 1.
std::int64_t WorstWindow(const Marks& marks, int size);

} // namespace boxreel
