// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/// Collects the changed areas of a picture and returns them as a few rectangles without overlap.
/// Renderer uses it for what to redraw and what to read.
namespace boxreel
{

class DirtyTiles
{
public:
    DirtyTiles(int width, int height);

    /// `bounds` inside the picture; may be empty.
    void Add(const PixelBounds& bounds);
    void AddAll();
    void Clear();
    bool IsEmpty() const { return m_firstRow >= m_lastRow; }

    /// True if a rectangle, not empty and inside the picture, touches a dirty tile.
    bool Touches(const PixelBounds& bounds) const;

    /// Replaces `rectangles` by a cover of all added bounds, sorted by y0, inside the picture and
    /// without overlap. To reduce their number, up to about `gap` clean tiles of kSize pixels
    /// beside dirty ones are included.
    void Gather(int gap, std::vector<PixelBounds>& rectangles);

    /// Smaller tiles include fewer unchanged pixels, larger ones give fewer rectangles. Even, so
    /// that rectangles match the cells of subsampled chroma.
    static constexpr int kSize = 4;

private:
    using Tile = std::uint8_t;
    Tile* Row(int row) { return m_tiles.data() + std::size_t(row) * std::size_t(m_columns); }
    const Tile* Row(int row) const
    {
        return m_tiles.data() + std::size_t(row) * std::size_t(m_columns);
    }
    void CloseGaps(int row, int gap);
    void Widen(int row, int neighbour, int gap);

    int m_width;
    int m_height;
    int m_columns;
    int m_rows;
    int m_firstRow = 0;        // all dirty tiles are in these rows
    int m_lastRow = 0;         // excluded
    bool m_isAll = false;      // added by one call for the whole picture
    std::vector<Tile> m_tiles; // 0 or 1
};

} // namespace boxreel
