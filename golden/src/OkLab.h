// SPDX-License-Identifier: MIT
#pragma once

#include "Lanes.h"

#include <cstdint>

/// Colours in OKLab, the space in which equal distances look about equally different. Used by the
/// comparison of pictures only; every compiler and C library gives the same bits, because nothing
/// but +, -, *, / and the square root (all correctly rounded by IEEE 754) is used.
namespace boxreel
{

struct OkLab
{
    double lightness = 0.0; ///< 0 black to 1 white
    double a = 0.0;         ///< green to red, about -0.4 to 0.4
    double b = 0.0;         ///< blue to yellow, about -0.4 to 0.4
};

/// Of an opaque sRGB colour.
OkLab ToOkLab(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// Euclidean; black to white is 1.
double Distance(const OkLab& p, const OkLab& q);

/// Of two premultiplied RGBA pixels: laid on black and laid on white, the larger distance counts,
/// so that a change of opacity alone is seen too.
double PixelDistance(const std::uint8_t* p, const std::uint8_t* q);

/// PixelDistance of four pairs at once, the bytes of pixels as they lie in memory, up to kNearly:
/// enough to see that a pair is far from a limit.
Floats NearlyPixelDistance(Words p, Words q);

/// A cube root is off by a share of 3e-5 at most, and none is larger than 1. The sums of the
/// magnitudes in the rows of OKLab's matrix are 1.01, 4.86 and 1.62, so a colour is off by 1.56e-4,
/// a pair by 3.2e-4, and the rest is for rounding. Smaller, and a verdict could depend on it;
/// larger, and more pairs are computed exactly.
inline constexpr float kNearly = 4e-4f;

} // namespace boxreel
