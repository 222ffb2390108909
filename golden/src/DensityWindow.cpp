// SPDX-License-Identifier: MIT
#include "DensityWindow.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace boxreel
{

namespace
{

// Returns the marks of a row within the columns of their box.
const Mark* RowOf(const Marks& marks, int y)
{
    return marks.marks.data() + std::size_t(y) * std::size_t(marks.width) + marks.over.x0;
}

// Returns the largest sum of `size` columns that ends at one of begin to end - 1. `before`: the sum
// of the `size` columns before these.
template <class Count>
std::int64_t WorstEndingIn(const std::vector<Count>& inColumn, int begin, int end, int size,
                           std::int64_t before)
{
    std::int64_t sum = before;
    std::int64_t worst = 0;
    for (int x = begin; x < end; ++x)
    {
        sum += inColumn[std::size_t(x)] -
               std::int64_t(x >= size ? inColumn[std::size_t(x - size)] : Count(0));
        worst = std::max(worst, sum);
    }
    return worst;
}

// Returns the largest sum of `size` columns above `worst`, or `worst`. A window spans at most two
// blocks of columns, so the sum of both blocks is an upper bound.
template <class Count>
std::int64_t WorstOfRow(const std::vector<Count>& inColumn, int size, std::int64_t worst)
{
    const int width = int(inColumn.size());
    std::int64_t before = 0;
    for (int x = 0, end = 0; end < width; x = end)
    {
        end = x + std::min(size, width - x);
        const std::int64_t block =
            std::accumulate(inColumn.begin() + x, inColumn.begin() + end, std::int64_t(0));
        if (before + block > worst)
        {
            worst = std::max(worst, WorstEndingIn(inColumn, x, end, size, before));
        }
        before = block;
    }
    return worst;
}

// `inColumn` contains per column the marks of the last `size` rows; a window slides over it.
// Windows that extend beyond the picture are harmless: one inside contains at least the same
// pixels. Count can store `size`.
template <class Count>
std::int64_t Worst(const Marks& marks, int size)
{
    const PixelBox& box = marks.over;
    const std::size_t width = std::size_t(box.x1 - box.x0 + 1);
    std::vector<Count> inColumn(width, 0);
    std::int64_t worst = 0;
    std::int64_t inRows = 0;                             // in the last `size` rows
    const std::int64_t full = std::int64_t(size) * size; // maximum of a window
    for (int y = box.y0; y <= box.y1 && worst < full; ++y)
    {
        if (y - box.y0 >= size && marks.overInRow[std::size_t(y - size)] > 0)
        {
            const Mark* gone = RowOf(marks, y - size);
            for (std::size_t i = 0; i < width; ++i)
            {
                inColumn[i] = Count(inColumn[i] - (gone[i] == Mark::Over));
            }
            inRows -= marks.overInRow[std::size_t(y - size)];
        }
        if (marks.overInRow[std::size_t(y)] == 0)
        {
            continue; // no sum has increased
        }
        const Mark* row = RowOf(marks, y);
        for (std::size_t i = 0; i < width; ++i)
        {
            inColumn[i] = Count(inColumn[i] + (row[i] == Mark::Over));
        }
        inRows += marks.overInRow[std::size_t(y)];
        worst = inRows > worst ? WorstOfRow(inColumn, size, worst) : worst;
    }
    return worst;
}

} // namespace

std::int64_t WorstWindow(const Marks& marks, int size)
{
    return size <= std::numeric_limits<std::uint16_t>::max() ? Worst<std::uint16_t>(marks, size)
                                                             : Worst<std::uint32_t>(marks, size);
}

} // namespace boxreel
