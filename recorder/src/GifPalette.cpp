// SPDX-License-Identifier: MIT
#include "GifPalette.h"

#include <algorithm>

namespace boxreel
{

namespace
{

constexpr std::size_t kFirstTable = 1 << 12;
constexpr std::size_t kMaxColors = 1 << 18; // maximum number of remembered colours, to limit
                                            // memory
constexpr int kFar = 12; // a visible difference in one channel of a flat drawing [1/255]
constexpr std::size_t kFarShare = 2000; // one pixel in this many may differ by more than kFar
constexpr std::size_t kFlatShare =
    1000; // a colour of at least one pixel in this many is an area, and must be exact
constexpr std::uint32_t kFewPixels = 16; // minimum number of pixels of an area

std::uint32_t ColorAt(const std::uint8_t* pixel)
{
    return std::uint32_t(pixel[0]) << 16 | std::uint32_t(pixel[1]) << 8 | pixel[2];
}

int Channel(std::uint32_t color, int axis)
{
    return int(color >> (16 - 8 * axis) & 0xff);
}

int SquaredDistance(std::uint32_t a, std::uint32_t b)
{
    int sum = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
        const int d = Channel(a, axis) - Channel(b, axis);
        sum += d * d;
    }
    return sum;
}

struct Weighted
{
    std::uint32_t color;
    std::uint32_t pixels;
};

/// Sums over colours, which give their squared error about the mean. Integers, so that the result
/// does not depend on the order: 8192^2 pixels times 255^2 fits.
struct Moments
{
    std::int64_t pixels = 0;
    std::int64_t sum[3] = {};
    std::int64_t squares[3] = {};

    void Add(const Weighted& entry)
    {
        pixels += entry.pixels;
        for (int axis = 0; axis < 3; ++axis)
        {
            const std::int64_t value = Channel(entry.color, axis);
            sum[axis] += value * entry.pixels;
            squares[axis] += value * value * entry.pixels;
        }
    }
    Moments Minus(const Moments& other) const
    {
        Moments rest = *this;
        rest.pixels -= other.pixels;
        for (int axis = 0; axis < 3; ++axis)
        {
            rest.sum[axis] -= other.sum[axis];
            rest.squares[axis] -= other.squares[axis];
        }
        return rest;
    }
    double Error(int axis) const
    {
        return pixels == 0
                   ? 0.0
                   : double(squares[axis]) - double(sum[axis]) * double(sum[axis]) / double(pixels);
    }
    double Error() const { return Error(0) + Error(1) + Error(2); }
};

/// A set of similar colours that share one entry of the palette.
struct Box
{
    std::size_t begin = 0;
    std::size_t end = 0;
    Moments moments;
};

Box MakeBox(const std::vector<Weighted>& colors, std::size_t begin, std::size_t end)
{
    Box box{begin, end, {}};
    for (std::size_t i = begin; i < end; ++i)
    {
        box.moments.Add(colors[i]);
    }
    return box;
}

/// Returns the cut along the widest axis with the smallest squared error.
std::size_t BestCut(std::vector<Weighted>& colors, const Box& box)
{
    int widest = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
        widest = box.moments.Error(axis) > box.moments.Error(widest) ? axis : widest;
    }
    std::sort(colors.begin() + std::ptrdiff_t(box.begin), colors.begin() + std::ptrdiff_t(box.end),
              [widest](const Weighted& a, const Weighted& b) {
                  const int u = Channel(a.color, widest);
                  const int v = Channel(b.color, widest);
                  return u != v ? u < v : a.color < b.color;
              });
    std::size_t best = box.begin + 1;
    double leastError = box.moments.Error() + 1.0;
    Moments left;
    for (std::size_t i = box.begin; i + 1 < box.end; ++i)
    {
        left.Add(colors[i]);
        const double error = left.Error() + box.moments.Minus(left).Error();
        if (error < leastError)
        {
            leastError = error;
            best = i + 1;
        }
    }
    return best;
}

/// Returns the colour that fills most of the box, otherwise the mean.
std::uint32_t ColorOf(const std::vector<Weighted>& colors, const Box& box)
{
    Weighted maximum = colors[box.begin];
    for (std::size_t i = box.begin + 1; i < box.end; ++i)
    {
        maximum = colors[i].pixels > maximum.pixels ? colors[i] : maximum;
    }
    const Moments& m = box.moments;
    if (std::int64_t(maximum.pixels) * 2 >= m.pixels)
    {
        return maximum.color;
    }
    std::uint32_t mean = 0;
    for (const std::int64_t sum : m.sum)
    {
        mean = mean << 8 | std::uint32_t((sum + m.pixels / 2) / m.pixels);
    }
    return mean;
}

/// Median cut that always splits the box with the largest squared error. After Heckbert, "Color
/// image quantization for frame buffer display", 1982, and Wu, "Efficient statistical computations
/// for optimal color quantization", 1991. `colors` has more than `count` elements.
std::vector<std::uint32_t> Quantize(std::vector<Weighted>& colors, std::size_t count)
{
    std::vector<Box> boxes{MakeBox(colors, 0, colors.size())};
    while (boxes.size() < count)
    {
        auto worst = boxes.end();
        for (auto box = boxes.begin(); box != boxes.end(); ++box)
        {
            if (box->end - box->begin > 1 &&
                (worst == boxes.end() || box->moments.Error() > worst->moments.Error()))
            {
                worst = box;
            }
        }
        const Box whole = *worst;
        const std::size_t cut = BestCut(colors, whole);
        *worst = MakeBox(colors, whole.begin, cut);
        boxes.push_back(MakeBox(colors, cut, whole.end));
    }
    std::vector<std::uint32_t> palette;
    palette.reserve(boxes.size());
    for (const Box& box : boxes)
    {
        palette.push_back(ColorOf(colors, box));
    }
    return palette;
}

} // namespace

GifPalette::GifPalette() : m_table(kFirstTable)
{
    m_colors.fill(0xff000000u);
}

GifPalette::Entry& GifPalette::Find(std::uint32_t color)
{
    const std::size_t mask = m_table.size() - 1;
    std::size_t slot = (color * 0x9e3779b1u >> 7) & mask;
    while (m_table[slot].color != color && m_table[slot].color != kNoColor)
    {
        slot = (slot + 1) & mask;
    }
    if (m_table[slot].color == kNoColor)
    {
        if (m_tableUsed * 2 >= m_table.size())
        {
            Grow();
            return Find(color);
        }
        m_table[slot].color = color;
        ++m_tableUsed;
    }
    return m_table[slot];
}

void GifPalette::Grow()
{
    std::vector<Entry> old(m_table.size() * 2);
    old.swap(m_table);
    m_tableUsed = 0;
    for (const Entry& entry : old)
    {
        if (entry.color != kNoColor)
        {
            Find(entry.color) = entry;
        }
    }
}

/// Clears the table, not the palette.
void GifPalette::Forget()
{
    m_table.assign(kFirstTable, Entry{});
    m_tableUsed = 0;
}

void GifPalette::Count(const Frame& frame)
{
    m_frameColors.clear();
    const std::uint8_t* pixel = frame.rgba.data();
    const std::uint8_t* const end = pixel + frame.rgba.size();
    while (pixel != end)
    {
        const std::uint32_t color = ColorAt(pixel);
        std::uint32_t run = 0;
        for (; pixel != end && ColorAt(pixel) == color; pixel += 4)
        {
            ++run;
        }
        Entry& entry = Find(color);
        if (entry.pixels == 0)
        {
            m_frameColors.push_back(color);
        }
        entry.pixels += run;
    }
}

void GifPalette::Match(Entry& entry) const
{
    int nearest = 256 * 256 * 3;
    for (std::size_t i = 0; i < m_used && nearest > 0; ++i)
    {
        const int distance = SquaredDistance(m_colors[i], entry.color);
        if (distance < nearest)
        {
            nearest = distance;
            entry.index = std::uint16_t(i);
        }
    }
}

/// Maps every colour of the frame to an index; new colours get their own entries while there are
/// any.
void GifPalette::AddNewColors()
{
    for (const std::uint32_t color : m_frameColors)
    {
        Entry& entry = Find(color);
        if (entry.index == kNoIndex)
        {
            Match(entry);
        }
        const bool isExact =
            entry.index != kNoIndex && (m_colors[entry.index] & 0xffffffu) == color;
        if (!isExact && m_used < kSize)
        {
            entry.index = std::uint16_t(m_used);
            m_colors[m_used++] = 0xff000000u | color;
        }
    }
}

bool GifPalette::IsMissingColors()
{
    std::size_t total = 0;
    std::size_t far = 0;
    std::uint32_t largestInexact = 0;
    for (const std::uint32_t color : m_frameColors)
    {
        const Entry& entry = Find(color);
        const int distance = SquaredDistance(m_colors[entry.index], color);
        total += entry.pixels;
        far += distance > kFar * kFar ? entry.pixels : 0;
        largestInexact = distance > 0 ? std::max(largestInexact, entry.pixels) : largestInexact;
    }
    if (m_frameColors.size() <= kSize)
    {
        return largestInexact > 0; // this frame can be exact
    }
    return far > kFewPixels + total / kFarShare ||
           largestInexact > std::max<std::size_t>(kFewPixels, total / kFlatShare);
}

/// Computes a palette for the current frame; keeps old colours if possible.
void GifPalette::Rebuild()
{
    const std::vector<std::uint32_t> old(m_colors.begin(),
                                         m_colors.begin() + std::ptrdiff_t(m_used));
    std::vector<std::uint32_t> colors = m_frameColors;
    if (colors.size() > kSize)
    {
        std::vector<Weighted> weighted;
        for (const std::uint32_t color : m_frameColors)
        {
            weighted.push_back({color, Find(color).pixels});
        }
        colors = Quantize(weighted, kSize);
    }
    for (Entry& entry : m_table)
    {
        entry.index = kNoIndex;
    }
    m_used = 0;
    for (const std::uint32_t color : colors)
    {
        m_colors[m_used++] = 0xff000000u | color;
    }
    for (const std::uint32_t color : old)
    {
        if (m_used < kSize && std::find(m_colors.begin(), m_colors.begin() + std::ptrdiff_t(m_used),
                                        color) == m_colors.begin() + std::ptrdiff_t(m_used))
        {
            m_colors[m_used++] = color;
        }
    }
    for (const std::uint32_t color : m_frameColors)
    {
        Match(Find(color));
    }
}

bool GifPalette::Map(const Frame& frame, std::uint8_t* indices, std::size_t stride)
{
    if (m_tableUsed > kMaxColors)
    {
        Forget();
    }
    Count(frame);
    AddNewColors();
    if (IsMissingColors())
    {
        Rebuild();
    }
    bool isExact = true;
    for (const std::uint32_t color : m_frameColors)
    {
        Entry& entry = Find(color);
        entry.pixels = 0;
        isExact = isExact && (m_colors[entry.index] & 0xffffffu) == color;
    }
    std::uint32_t lastColor = kNoColor;
    std::uint8_t lastIndex = 0;
    for (int y = 0; y < frame.height; ++y)
    {
        const std::uint8_t* pixel = frame.Pixel(0, y);
        std::uint8_t* row = indices + std::size_t(y) * stride;
        for (int x = 0; x < frame.width; ++x, pixel += 4)
        {
            const std::uint32_t color = ColorAt(pixel);
            if (color != lastColor)
            {
                lastColor = color;
                lastIndex = std::uint8_t(Find(color).index);
            }
            row[x] = lastIndex;
        }
    }
    return isExact;
}

} // namespace boxreel
