// SPDX-License-Identifier: MIT
#pragma once

#include "DifferencePicture.h"

#include <render/Frame.h>

#include <cstdint>

/// The change that an edge shifted by a fraction of a pixel explains. Called by Compare for single
/// different pixels; reads only the expected picture around them.
namespace boxreel
{

/// True if `actual` at (x, y) is explained by edges shifted up to `shift` pixels and colours within
/// `tolerance`, an OKLab distance.
bool EdgeExplains(const Frame& expected, int x, int y, const std::uint8_t* actual, double tolerance,
                  double shift);

/// EdgeExplains for many pixels, with a filter that calls it only where rounding could matter.
/// Tested by PixelMarksTest.
/// Changes the marks over the tolerance from `begin` to end - 1 of a row to Within if EdgeExplains
/// holds; returns their number.
int ExcuseEdges(const Frame& expected, const Frame& actual, int y, int begin, int end,
                double tolerance, double shift, Mark* row);

} // namespace boxreel
