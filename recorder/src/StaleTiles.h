// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstdint>
#include <vector>

/// The outdated areas of a copy of a frame, in square tiles. An area that changed several times is
/// copied once. Used by EncoderThread for each frame of its ring.
namespace boxreel
{

class StaleTiles
{
public:
    /// Marks a change of the original; bounds may extend beyond the frame.
    void Mark(const PixelBounds& part);

    /// Copies the outdated tiles, or all of them when `copy` has another size, and clears the
    /// marks.
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
