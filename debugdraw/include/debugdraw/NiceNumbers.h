// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// @file
/// Round numbers for ticks, scale bars and dimensions. Plain arithmetic, independent of the locale.
namespace boxreel
{

/// Returns the largest of …, 0.1, 0.2, 0.5, 1, 2, 5, 10, … that is <= `limit`, which is > 0 and
/// finite.
double NiceBelow(double limit);

/// Returns the smallest of these that is >= `limit`.
double NiceAbove(double limit);

/// Formats with the decimals of `step`, one of the numbers above: "-1.5" by 0.5, "20" by 10. Never
/// "-0".
std::string NumberBy(double value, double step);

/// Formats with about three significant digits: "0.125", "1.25", "12.5", "125", "1.20".
std::string NumberMeasured(double value);

/// Formats with up to three decimals, without trailing zeros: "0.5", "2", "1.333".
std::string NumberPlain(double value);

} // namespace boxreel
