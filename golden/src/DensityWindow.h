// SPDX-License-Identifier: MIT
#pragma once

#include "DifferencePicture.h"

#include <cstdint>

/// Whether what differs is scattered or stands together. Asked by Compare once all pixels are
/// marked. Tested by CompareTest, CompareWindows.
namespace boxreel
{

/// Most marks over the tolerance in any window of size x size pixels, wherever it lies. size >= 1.
std::int64_t WorstWindow(const Marks& marks, int size);

} // namespace boxreel
