// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/// Gathers what has changed in a picture, and says it in a few rectangles that do not overlap. Used
/// by Renderer for what to draw anew, and for what to read.
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

    /// Whether a rectangle inside the picture, not empty, lies on something dirty.
    bool Touches(const PixelBounds& bounds) const;

    /// Replaces `rectangles` by what holds all that was added, sorted by y0. They are inside the
    /// picture and share no pixel. To have fewer, up to about `gap` clean tiles of kSize pixels
    /// beside dirty ones are made dirty too.
    void Gather(int gap, std::vector<PixelBounds>& rectangles);

    /// Finer tiles hold less that has not changed, coarser ones make fewer rectangles. Even, so
    /// that rectangles are whole cells of a film's coarser colours too.
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
    bool m_isAll = false;      // added in one piece
    std::vector<Tile> m_tiles; // 0 or 1
};

} // namespace boxreel
