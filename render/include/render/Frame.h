// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// @file
/// A picture in memory: what renderers fill, files store, films are made of and golden tests
/// compare. Header only; any program's RGBA picture can be put into one.
namespace boxreel
{

/// A rectangle of pixels, y down, upper bounds excluded.
struct PixelBounds
{
    int x0 = 0; ///< first column
    int y0 = 0; ///< first row
    int x1 = 0; ///< one beyond the last column
    int y1 = 0; ///< one beyond the last row
    /// Whether it holds no pixel.
    bool IsEmpty() const { return x1 <= x0 || y1 <= y0; }
    /// Number of pixels; only of one that is not empty.
    std::int64_t Area() const { return std::int64_t(x1 - x0) * (y1 - y0); }
    /// Whether all members are equal.
    friend bool operator==(const PixelBounds&, const PixelBounds&) = default;
};

/// Empty, in one way or another, when they share no pixel.
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
    /// Transparent; w and h 0 or more [px].
    Frame(int w, int h) : width(w), height(h), rgba(std::size_t(w) * std::size_t(h) * 4) {}

    /// The four bytes of a pixel; 0 <= x < width, 0 <= y < height.
    std::uint8_t* Pixel(int x, int y)
    {
        return rgba.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
    }
    /// The same, to be read.
    const std::uint8_t* Pixel(int x, int y) const
    {
        return rgba.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
    }
    /// Whether all members are equal.
    friend bool operator==(const Frame&, const Frame&) = default;
};

} // namespace boxreel
