// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstdint>
#include <vector>

/// Where a copy of a frame shows an older one, in square tiles: what has changed several times
/// since is copied once. Used by EncoderThread for each frame of its ring.
namespace boxreel
{

class StaleTiles
{
public:
    /// The original has changed here; bounds may reach beyond the frame.
    void Mark(const PixelBounds& part);

    /// Copies the stale tiles, all of them when `copy` is of another size. Nothing is stale then.
    void BringUpToDate(const Frame& original, Frame& copy);

private:
    static constexpr int kTile = 16; // [px]

    void Resize(int width, int height);
    void CopyTiles(const Frame& original, int row, int first, int end, Frame& copy) const;

    int m_columns = 0; // of tiles
    int m_rows = 0;
    std::vector<std::uint8_t> m_isStale; // row by row
};

} // namespace boxreel
