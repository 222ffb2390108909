// SPDX-License-Identifier: MIT
#pragma once

#include "Lanes.h"

#include <cstdint>

/// Colours in OKLab, a space in which equal distances look about equally different. Used only for
/// comparing pictures. Every compiler and C library gives the same bits, because only +, -, *, /
/// and the square root are used. IEEE 754 rounds all of them correctly.
namespace boxreel
{

struct OkLab
{
    double lightness = 0.0; ///< 0 black to 1 white
    double a = 0.0;         ///< green to red, about -0.4 to 0.4
    double b = 0.0;         ///< blue to yellow, about -0.4 to 0.4
};

/// Converts an opaque sRGB colour.
OkLab ToOkLab(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// Returns the Euclidean distance; black to white is 1.
double Distance(const OkLab& p, const OkLab& q);

/// Returns the distance of two premultiplied RGBA pixels: the maximum over a black and a white
/// background, to detect changes of opacity.
double PixelDistance(const std::uint8_t* p, const std::uint8_t* q);

/// Returns PixelDistance of four pairs of pixels, stored as bytes in memory, with an error up to
/// kNearly: sufficient to see that a pair is far from a limit.
Floats NearlyPixelDistance(Words p, Words q);

/// The relative error of a cube root is at most 3e-5, and none is larger than 1. The sums of
/// absolute values in the rows of OKLab's matrix are 1.01, 4.86 and 1.62. The error of a colour is
/// therefore 1.56e-4, that of a pair 3.2e-4, and the rest is for rounding. Smaller could change a
/// verdict; larger computes more pairs exactly.
inline constexpr float kNearly = 4e-4f;

} // namespace boxreel
