// SPDX-License-Identifier: MIT
#pragma once

#include "DifferencePicture.h"

#include <render/Frame.h>

#include <cstdint>

/// What an edge that lies a fraction of a pixel elsewhere may change. Asked by Compare about single
/// pixels that differ; looks at the expected picture around them, never at the actual one.
namespace boxreel
{

/// Whether `actual` may stand at (x, y) if edges may lie `shift` pixels elsewhere, and colours be
/// off by `tolerance`, an OKLab distance.
bool EdgeExplains(const Frame& expected, int x, int y, const std::uint8_t* actual, double tolerance,
                  double shift);

/// EdgeExplains for many pixels, by a filter that asks it only where rounding could matter. Tested
/// by PixelMarksTest.
/// Of a row's marks over the tolerance from `begin` to end - 1, those that EdgeExplains become
/// Within; returns how many.
int ExcuseEdges(const Frame& expected, const Frame& actual, int y, int begin, int end,
                double tolerance, double shift, Mark* row);

} // namespace boxreel
