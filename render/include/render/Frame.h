// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// A picture in memory: what renderers fill, files store, films are made of and golden tests compare.
/// Header only; any program's RGBA picture can be put into one.
namespace boxreel
{

struct Frame
{
    int width = 0;                  ///< [px]
    int height = 0;                 ///< [px]
    std::vector<std::uint8_t> rgba; ///< rows top to bottom, premultiplied, sRGB, no padding

    Frame() = default;
    Frame(int w, int h) : width(w), height(h), rgba(std::size_t(w) * std::size_t(h) * 4) {}

    std::uint8_t* Pixel(int x, int y) { return rgba.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4; }
    const std::uint8_t* Pixel(int x, int y) const
    {
        return rgba.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
    }
    friend bool operator==(const Frame&, const Frame&) = default;
};

} // namespace boxreel
