// SPDX-License-Identifier: MIT
#pragma once

#include "Chart.h"
#include "ChartCanvas.h"

#include <functional>

namespace boxreel
{

/// Paints on a white picture of `width` by `height` points and returns the bytes of the file.
Result<std::vector<std::uint8_t>> PaintFile(ChartFormat format, int width, int height,
                                            const std::function<void(ChartCanvas&)>& paint);

} // namespace boxreel
