// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/// The picture of a difference. Compare decides what each pixel is; this only paints it.
namespace boxreel
{

enum class Mark : std::uint8_t
{
    Same,
    Within, ///< different, but not by more than is allowed there
    Over,
    Ignored, ///< not compared
};

/// Pixels from (x0, y0) to (x1, y1), both included; empty while x1 < x0.
struct PixelBox
{
    int x0 = 0, y0 = 0, x1 = -1, y1 = -1;
    void Include(int x, int y);
};

/// What each pixel of a picture is. The boxes keep the work on the marks to where there are any.
struct Marks
{
    int width = 0;
    int height = 0;
    std::vector<Mark> marks;    ///< rows top to bottom; empty when nothing differs
    PixelBox different;         ///< all that are not Same
    PixelBox over;              ///< all that are Over
    std::vector<int> overInRow; ///< how many of each row are Over; empty when nothing differs

    Mark At(int x, int y) const
    {
        return marks[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    /// A row to write marks into. Whoever does says so to the boxes and to `overInRow`.
    Mark* Row(int y);
    void Ignore(const PixelBounds& bounds); ///< what of it lies in the picture
};

/// `expected` is at most as large as the marks.
Frame PaintDifference(const Frame& expected, const Marks& marks);

} // namespace boxreel
