// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// @file
/// A picture in memory, used by renderers, files, films and golden tests. Header only; it can hold
/// any RGBA picture.
namespace boxreel
{

/// A rectangle of pixels, y down, upper bounds excluded.
struct PixelBounds
{
    int x0 = 0; ///< first column
    int y0 = 0; ///< first row
    int x1 = 0; ///< one beyond the last column
    int y1 = 0; ///< one beyond the last row
    /// True if it contains no pixel.
    bool IsEmpty() const { return x1 <= x0 || y1 <= y0; }
    /// Returns the number of pixels; the rectangle must not be empty.
    std::int64_t Area() const { return std::int64_t(x1 - x0) * (y1 - y0); }
    /// True if all members are equal.
    friend bool operator==(const PixelBounds&, const PixelBounds&) = default;
};

/// Returns the common pixels; empty if there are none.
inline PixelBounds Intersection(const PixelBounds& a, const PixelBounds& b)
{
    return {a.x0 > b.x0 ? a.x0 : b.x0, a.y0 > b.y0 ? a.y0 : b.y0, a.x1 < b.x1 ? a.x1 : b.x1,
            a.y1 < b.y1 ? a.y1 : b.y1};
}

/// A picture.
struct Frame
{
    int width = 0;                  ///< columns [px]
    int height = 0;                 ///< rows [px]
    std::vector<std::uint8_t> rgba; ///< rows top to bottom, premultiplied, sRGB, no padding

    Frame() = default;
    /// Creates a transparent frame; w, h >= 0 [px].
    Frame(int w, int h) : width(w), height(h), rgba(std::size_t(w) * std::size_t(h) * 4) {}

    /// Returns the four bytes of a pixel; 0 <= x < width, 0 <= y < height.
    std::uint8_t* Pixel(int x, int y)
    {
        return rgba.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
    }
    /// Same as above, read-only.
    const std::uint8_t* Pixel(int x, int y) const
    {
        return rgba.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
    }
    /// True if all members are equal.
    friend bool operator==(const Frame&, const Frame&) = default;
};

} // namespace boxreel
