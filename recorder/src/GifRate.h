// SPDX-License-Identifier: MIT
#pragma once

#include <recorder/FrameClock.h>

#include <cstdint>
#include <span>

/// The frame rate of an animated GIF, which stores delays alone, each rounded. libav's guess looks
/// at the first frames, and at how many of them depends on its version. Used by FFmpegReader.
namespace boxreel
{

/// The rate of which all times are rounded multiples, so that held frames count as several: a usual
/// rate where one fits, else the mean of the shortest delays. `delays`: how long each frame is
/// shown [1/100 s], more than 0.
Rational RateOfGif(std::span<const std::int64_t> delays);

} // namespace boxreel
