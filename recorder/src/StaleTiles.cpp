// SPDX-License-Identifier: MIT
#include "StaleTiles.h"

#include <algorithm>
#include <cstring>

namespace boxreel
{

void StaleTiles::Resize(int width, int height)
{
    m_columns = (width + kTile - 1) / kTile;
    m_rows = (height + kTile - 1) / kTile;
    m_isStale.assign(std::size_t(m_columns) * std::size_t(m_rows), 0);
}

void StaleTiles::Mark(const PixelBounds& part)
{
    const int left = std::clamp(part.x0 / kTile, 0, m_columns);
    const int right = std::clamp((part.x1 + kTile - 1) / kTile, left, m_columns);
    const int top = std::clamp(part.y0 / kTile, 0, m_rows);
    const int bottom = std::clamp((part.y1 + kTile - 1) / kTile, top, m_rows);
    for (int row = top; row < bottom; ++row)
    {
        const auto begin = m_isStale.begin() + std::ptrdiff_t(row) * m_columns;
        std::fill(begin + left, begin + right, std::uint8_t(1));
    }
}

void StaleTiles::BringUpToDate(const Frame& original, Frame& copy)
{
    if (copy.width != original.width || copy.height != original.height)
    {
        copy = original;
        Resize(original.width, original.height);
        return;
    }
    for (int row = 0; row < m_rows; ++row)
    {
        const auto begin = m_isStale.begin() + std::ptrdiff_t(row) * m_columns;
        const auto end = begin + m_columns;
        for (auto first = std::find(begin, end, 1); first != end;)
        {
            const auto last = std::find(first, end, 0);
            CopyTiles(original, row, int(first - begin), int(last - begin), copy);
            first = std::find(last, end, 1);
        }
    }
    std::fill(m_isStale.begin(), m_isStale.end(), std::uint8_t(0));
}

/// Copies the tiles from `first` to before `end` of a row, as one rectangle.
void StaleTiles::CopyTiles(const Frame& original, int row, int first, int end, Frame& copy) const
{
    const int left = first * kTile;
    const int right = std::min(end * kTile, original.width);
    const int bottom = std::min((row + 1) * kTile, original.height);
    for (int y = row * kTile; y < bottom; ++y)
    {
        std::memcpy(copy.Pixel(left, y), original.Pixel(left, y), std::size_t(right - left) * 4);
    }
}

} // namespace boxreel
