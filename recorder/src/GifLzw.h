// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// The compression of GIF: LZW with codes of up to twelve bits (Welch, "A technique for
/// high-performance data compression", 1984, as in appendix F of GIF89a). Used by GifFilm.
namespace boxreel
{

/// Appends the image data of a GIF to `out`: the index width, blocks of at most 255 bytes, and the
/// terminating empty block. `indices`: not empty, each below 2^`bits`; `bits`: 2 to 8.
void AppendGifLzw(std::span<const std::uint8_t> indices, int bits, std::vector<std::uint8_t>& out);

} // namespace boxreel
