// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// The compression of GIF: LZW with codes that grow from a few bits to twelve (Welch, "A technique
/// for high-performance data compression", 1984, as GIF89a has it in its appendix F). Used by
/// GifFilm.
namespace boxreel
{

/// Appends the image data of a GIF to `out`: the size of its indices, blocks of at most 255 bytes,
/// and the empty one that ends them. `indices`: not empty, each below 2^`bits`; `bits`: 2 to 8.
void AppendGifLzw(std::span<const std::uint8_t> indices, int bits, std::vector<std::uint8_t>& out);

} // namespace boxreel
