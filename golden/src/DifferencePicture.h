// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/// Paints the picture of a difference from the marks of Compare.
namespace boxreel
{

enum class Mark : std::uint8_t
{
    Same,
    Within, ///< different, but within tolerance
    Over,
    Ignored, ///< not compared
};

/// Pixels from (x0, y0) to (x1, y1), both included; empty if x1 < x0.
struct PixelBox
{
    int x0 = 0, y0 = 0, x1 = -1, y1 = -1;
    void Include(int x, int y);
};

/// A mark per pixel. The boxes limit the work to where there are marks.
struct Marks
{
    int width = 0;
    int height = 0;
    std::vector<Mark> marks;    ///< rows top to bottom; empty without differences
    PixelBox different;         ///< bounds of all marks except Same
    PixelBox over;              ///< bounds of all Over marks
    std::vector<int> overInRow; ///< number of Over marks per row; empty without differences

    Mark At(int x, int y) const
    {
        return marks[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    /// Returns a row to write marks to. The caller updates the boxes and `overInRow`.
    Mark* Row(int y);
    void Ignore(const PixelBounds& bounds); ///< clipped to the picture
};

/// `expected` is at most as large as the marks.
Frame PaintDifference(const Frame& expected, const Marks& marks);

} // namespace boxreel
