// SPDX-License-Identifier: MIT
#include "DirtyTiles.h"

#include <algorithm>
#include <cstring>

namespace boxreel
{
namespace
{

// Above this number of rectangles the whole picture is dirty. Drawing it is not slower then, and
// finding the rectangles takes quadratic time.
constexpr std::size_t kMaxRectangles = 1024;

/// Calls `see(begin, end)` for every run of dirty tiles in a row.
template <class See>
void ForEachRun(const std::uint8_t* row, int columns, const See& see)
{
    const auto find = [row, columns](int from, int value) {
        const void* const found = std::memchr(row + from, value, std::size_t(columns - from));
        return found ? int(static_cast<const std::uint8_t*>(found) - row) : columns;
    };
    for (int begin = find(0, 1); begin < columns;)
    {
        const int end = find(begin, 0);
        see(begin, end);
        begin = find(end, 1);
    }
}

} // namespace

DirtyTiles::DirtyTiles(int width, int height)
    : m_width(width), m_height(height), m_columns((width - 1) / kSize + 1),
      m_rows((height - 1) / kSize + 1),
      m_tiles(std::size_t(m_columns) * std::size_t(m_rows), Tile(0))
{}

void DirtyTiles::Add(const PixelBounds& bounds)
{
    if (bounds.IsEmpty())
    {
        return;
    }
    const int row0 = bounds.y0 / kSize;
    const int row1 = (bounds.y1 - 1) / kSize + 1;
    m_isAll |= bounds == PixelBounds{0, 0, m_width, m_height};
    m_firstRow = IsEmpty() ? row0 : std::min(m_firstRow, row0);
    m_lastRow = std::max(m_lastRow, row1);
    for (int row = row0; row < row1; ++row)
    {
        std::fill(Row(row) + bounds.x0 / kSize, Row(row) + (bounds.x1 - 1) / kSize + 1, Tile(1));
    }
}

void DirtyTiles::AddAll()
{
    Add({0, 0, m_width, m_height});
}

void DirtyTiles::Clear()
{
    std::fill(Row(m_firstRow), Row(m_firstRow) + (m_lastRow - m_firstRow) * m_columns, Tile(0));
    m_firstRow = 0;
    m_lastRow = 0;
    m_isAll = false;
}

bool DirtyTiles::Touches(const PixelBounds& bounds) const
{
    const int row1 = std::min((bounds.y1 - 1) / kSize + 1, m_lastRow);
    const int column0 = bounds.x0 / kSize;
    const std::size_t columns = std::size_t((bounds.x1 - 1) / kSize + 1 - column0);
    for (int row = std::max(bounds.y0 / kSize, m_firstRow); row < row1; ++row)
    {
        if (std::memchr(Row(row) + column0, 1, columns))
        {
            return true;
        }
    }
    return false;
}

/// Marks short runs of clean tiles between two dirty runs of a row.
void DirtyTiles::CloseGaps(int row, int gap)
{
    Tile* const tiles = Row(row);
    int last = -1;
    ForEachRun(tiles, m_columns, [&](int begin, int end) {
        if (last >= 0 && begin - last <= gap)
        {
            std::fill(tiles + last, tiles + begin, Tile(1));
        }
        last = end;
    });
}

/// Marks tiles so that runs match those of the neighbouring row: two runs of the same width form
/// one rectangle.
void DirtyTiles::Widen(int row, int neighbour, int gap)
{
    Tile* const tiles = Row(row);
    ForEachRun(Row(neighbour), m_columns, [&](int begin, int end) {
        const int clean = int(std::count(tiles + begin, tiles + end, Tile(0)));
        if (clean < end - begin && clean <= gap + (end - begin) / 4)
        {
            std::fill(tiles + begin, tiles + end, Tile(1));
        }
    });
}

void DirtyTiles::Gather(int gap, std::vector<PixelBounds>& rectangles)
{
    rectangles.clear();
    if (m_isAll)
    {
        rectangles.push_back({0, 0, m_width, m_height});
        return;
    }
    for (int row = m_firstRow; row < m_lastRow; ++row)
    {
        CloseGaps(row, gap);
    }
    for (int row = m_firstRow + 1; row < m_lastRow; ++row)
    {
        Widen(row, row - 1, gap);
    }
    for (int row = m_lastRow - 2; row >= m_firstRow; --row)
    {
        Widen(row, row + 1, gap);
    }
    std::size_t open = 0; // the first rectangle that may continue in this row
    for (int row = m_firstRow; row < m_lastRow; ++row)
    {
        const int y0 = row * kSize;
        const int y1 = std::min(y0 + kSize, m_height);
        const std::size_t before = rectangles.size();
        while (open < before && rectangles[open].y1 < y0)
        {
            ++open;
        }
        ForEachRun(Row(row), m_columns, [&](int begin, int end) {
            const int x0 = begin * kSize;
            const int x1 = std::min(end * kSize, m_width);
            const auto from = rectangles.begin() + std::ptrdiff_t(open);
            const auto to = rectangles.begin() + std::ptrdiff_t(before);
            const auto found = std::find_if(from, to, [&](const PixelBounds& above) {
                return above.y1 == y0 && above.x0 == x0 && above.x1 == x1;
            });
            if (found != to)
            {
                found->y1 = y1;
            }
            else
            {
                rectangles.push_back({x0, y0, x1, y1});
            }
        });
        if (rectangles.size() > kMaxRectangles)
        {
            rectangles.assign(1, {0, 0, m_width, m_height});
            return;
        }
    }
}

} // namespace boxreel
