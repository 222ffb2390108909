// SPDX-License-Identifier: MIT
#pragma once

#include <recorder/FrameClock.h>

#include <cstdint>
#include <span>

/// The frame rate of an animated GIF, which stores only rounded delays. libav estimates it from the
/// first frames, and their number depends on its version. Used by FFmpegReader.
namespace boxreel
{

/// Returns the rate of which all times are rounded multiples, so that held frames count as several.
/// A common rate if one fits, otherwise the mean of the shortest delays. `delays`: duration of each
/// frame [1/100 s], > 0.
Rational RateOfGif(std::span<const std::int64_t> delays);

} // namespace boxreel
