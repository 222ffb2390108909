// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The 256 colours of a GIF of drawings: flat colours exactly, blends along edges as closely as
/// possible, no dithering. The palette is kept while it suffices, so that resting content keeps its
/// pixels. It is extended or recomputed for new colours. Used by the encoder.
namespace boxreel
{

class GifPalette
{
public:
    static constexpr std::size_t kSize = 256;

    GifPalette();

    /// Writes the index of each pixel to `indices` (rows of `stride` bytes). True if every pixel
    /// keeps its exact colour.
    bool Map(const Frame& frame, std::uint8_t* indices, std::size_t stride);

    const std::array<std::uint32_t, kSize>& Colors() const { return m_colors; } ///< 0xffRRGGBB

private:
    /// A colour of the film, in an open-addressed table.
    struct Entry
    {
        std::uint32_t color = kNoColor; ///< 0x00RRGGBB
        std::uint32_t pixels = 0;       ///< in the current frame
        std::uint16_t index = kNoIndex;
    };
    static constexpr std::uint32_t kNoColor = 0xffffffffu;
    static constexpr std::uint16_t kNoIndex = 0xffffu;

    Entry& Find(std::uint32_t color);
    void Grow();
    void Forget();
    void Count(const Frame& frame);
    void AddNewColors();
    bool IsMissingColors();
    void Rebuild();
    void Match(Entry& entry) const;

    std::array<std::uint32_t, kSize> m_colors{};
    std::size_t m_used = 0;                   ///< used entries of m_colors
    std::vector<Entry> m_table;               ///< size is a power of two
    std::size_t m_tableUsed = 0;              ///< entries with a colour
    std::vector<std::uint32_t> m_frameColors; ///< of the current frame, in order of appearance
};

} // namespace boxreel
