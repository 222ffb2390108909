// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

/// Pixels as words, for comparing and painting whole pixels. Used by DifferencePicture, EdgeRule
/// and PixelMarks.
namespace boxreel
{

/// Returns the four bytes of a pixel as stored in memory.
inline std::uint32_t PixelWord(const std::uint8_t* pixel)
{
    std::uint32_t word;
    std::memcpy(&word, pixel, 4);
    return word;
}

} // namespace boxreel
