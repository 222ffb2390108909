// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The 256 colours of a GIF made of drawings: flat colours exactly, the blends along edges as near
/// as they can be, no dither. The palette stays as long as it serves, so that what rests in the
/// film keeps its pixels, and grows or is made anew when colours turn up that it lacks. Used by the
/// encoder.
namespace boxreel
{

class GifPalette
{
public:
    static constexpr std::size_t kSize = 256;

    GifPalette();

    /// Writes the index of each pixel to `indices` (rows of `stride` bytes). Returns whether every
    /// pixel keeps its colour.
    bool Map(const Frame& frame, std::uint8_t* indices, std::size_t stride);

    const std::array<std::uint32_t, kSize>& Colors() const { return m_colors; } ///< 0xffRRGGBB

private:
    /// A colour the film has shown, in an open-addressed table.
    struct Entry
    {
        std::uint32_t color = kNoColor; ///< 0x00RRGGBB
        std::uint32_t pixels = 0;       ///< of the current frame
        std::uint16_t index = kNoIndex;
    };
    static constexpr std::uint32_t kNoColor = 0xffffffffu;
    static constexpr std::uint16_t kNoIndex = 0xffffu;

    Entry& Find(std::uint32_t color);
    void Grow();
    void Forget();
    void Count(const Frame& frame);
    void AddNewColors();
    bool LacksColors();
    void Rebuild();
    void Match(Entry& entry) const;

    std::array<std::uint32_t, kSize> m_colors{};
    std::size_t m_used = 0;                   ///< of m_colors
    std::vector<Entry> m_table;               ///< a power of two of them
    std::size_t m_tableUsed = 0;              ///< entries that hold a colour
    std::vector<std::uint32_t> m_frameColors; ///< of the current frame, in the order they turn up
};

} // namespace boxreel
