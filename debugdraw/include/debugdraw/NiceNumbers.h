// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// @file
/// Numbers for people: ticks, scale bars, measures. Plain arithmetic, whatever the locale.
namespace boxreel
{

/// The largest of …, 0.1, 0.2, 0.5, 1, 2, 5, 10, … that is not above `limit`, which is above 0 and
/// finite.
double NiceBelow(double limit);

/// The smallest that is not below `limit`.
double NiceAbove(double limit);

/// With as many decimals as a multiple of `step`, one of the above, needs: "0.25" is none, "-1.5"
/// by 0.5, "20" by 10. Never "-0".
std::string NumberBy(double value, double step);

/// With about three digits that count: "0.125", "1.25", "12.5", "125". "1.20" for 1.2.
std::string NumberMeasured(double value);

/// With up to three decimals, none that say nothing: "0.5", "2", "1.333".
std::string NumberPlain(double value);

} // namespace boxreel
