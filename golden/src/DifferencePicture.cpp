// SPDX-License-Identifier: MIT
#include "DifferencePicture.h"

#include "PixelWord.h"

#include <golden/Compare.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace boxreel
{

namespace
{

// A pixel as one word, for vectorized painting of rows. Byte 0 is red.
constexpr int Shift(int byte)
{
    return std::endian::native == std::endian::little ? 8 * byte : 24 - 8 * byte;
}

constexpr std::uint32_t Word(std::uint32_t r, std::uint32_t g, std::uint32_t b)
{
    return r << Shift(0) | g << Shift(1) | b << Shift(2) | 255u << Shift(3);
}

constexpr std::uint32_t kOver = Word(255, 40, 60);
constexpr std::uint32_t kWithin = Word(48, 90, 150);
constexpr std::uint32_t kIgnored = Word(150, 130, 40);
constexpr std::uint32_t kBox = Word(255, 255, 255);
constexpr std::uint32_t kSeparator = Word(170, 170, 170);
constexpr int kHatch = 6;          // [px] between lines of the hatching
constexpr int kBoxDistance = 6;    // [px] between the box and its content
constexpr int kSeparatorWidth = 4; // [px]

// Dark gray, at most 24 + 3/8 * 255 = 119, so that marks are visible on every background.
// Brightness is approximated by (2 r + 5 g + b) / 8, with shifts only.
std::uint32_t Faded(std::uint32_t pixel)
{
    const std::uint32_t r = pixel >> Shift(0) & 255u;
    const std::uint32_t g = pixel >> Shift(1) & 255u;
    const std::uint32_t b = pixel >> Shift(2) & 255u;
    const std::uint32_t brightness = (2 * r + (g << 2) + g + b) >> 3;
    const std::uint32_t gray = 24 + ((2 * brightness + brightness) >> 3);
    return gray << Shift(0) | gray << Shift(1) | gray << Shift(2) | 255u << Shift(3);
}

void Store(std::uint8_t* pixel, std::uint32_t word)
{
    std::memcpy(pixel, &word, 4);
}

void FadeRow(const std::uint8_t* from, std::uint8_t* to, int width)
{
    for (std::size_t i = 0; i < std::size_t(width) * 4; i += 4)
    {
        Store(to + i, Faded(PixelWord(from + i)));
    }
}

void FillRect(Frame& frame, int x0, int y0, int x1, int y1, std::uint32_t color)
{
    for (int y = std::max(y0, 0); y < std::min(y1, frame.height); ++y)
    {
        for (int x = std::max(x0, 0); x < std::min(x1, frame.width); ++x)
        {
            Store(frame.Pixel(x, y), color);
        }
    }
}

// Draws a thin box around the differences, because a single pixel is hard to find. It keeps a
// distance, so it never covers them; sides outside the picture are omitted.
void PaintBox(Frame& frame, const PixelBox& box)
{
    const int left = box.x0 - kBoxDistance, top = box.y0 - kBoxDistance;
    const int right = box.x1 + kBoxDistance, bottom = box.y1 + kBoxDistance;
    FillRect(frame, left, top, right + 1, top + 1, kBox);
    FillRect(frame, left, bottom, right + 1, bottom + 1, kBox);
    FillRect(frame, left, top, left + 1, bottom + 1, kBox);
    FillRect(frame, right, top, right + 1, bottom + 1, kBox);
}

void PaintMarks(Frame& frame, const Marks& marks)
{
    const PixelBox& box = marks.different;
    for (int y = box.y0; y <= box.y1; ++y)
    {
        for (int x = box.x0; x <= box.x1; ++x)
        {
            switch (marks.At(x, y))
            {
            case Mark::Same:
                break;
            case Mark::Within:
                Store(frame.Pixel(x, y), kWithin);
                break;
            case Mark::Over:
                Store(frame.Pixel(x, y), kOver);
                break;
            case Mark::Ignored:
                if ((x + y) % kHatch == 0)
                {
                    Store(frame.Pixel(x, y), kIgnored);
                }
                break;
            }
        }
    }
}

void Paste(const Frame& source, Frame& target, int left)
{
    for (int y = 0; y < source.height && source.width > 0; ++y)
    {
        std::memcpy(target.Pixel(left, y), source.Pixel(0, y), std::size_t(source.width) * 4);
    }
}

} // namespace

void PixelBox::Include(int x, int y)
{
    const bool first = x1 < x0;
    x0 = first ? x : std::min(x0, x);
    y0 = first ? y : std::min(y0, y);
    x1 = first ? x : std::max(x1, x);
    y1 = first ? y : std::max(y1, y);
}

Mark* Marks::Row(int y)
{
    if (marks.empty())
    {
        marks.resize(std::size_t(width) * std::size_t(height), Mark::Same);
        overInRow.resize(std::size_t(height));
    }
    return marks.data() + std::size_t(y) * std::size_t(width);
}

void Marks::Ignore(const PixelBounds& bounds)
{
    const PixelBounds inside = Intersection(bounds, {0, 0, width, height});
    if (inside.IsEmpty())
    {
        return;
    }
    for (int y = inside.y0; y < inside.y1; ++y)
    {
        std::fill(Row(y) + inside.x0, Row(y) + inside.x1, Mark::Ignored);
    }
    different.Include(inside.x0, inside.y0);
    different.Include(inside.x1 - 1, inside.y1 - 1);
}

Frame PaintDifference(const Frame& expected, const Marks& marks)
{
    // Rows are appended; filling the picture with zeros first would double the cost.
    Frame picture;
    picture.width = marks.width;
    picture.height = marks.height;
    picture.rgba.reserve(std::size_t(marks.width) * std::size_t(marks.height) * 4);
    std::vector<std::uint8_t> row(std::size_t(marks.width) * 4);
    for (int y = 0; y < marks.height && marks.width > 0; ++y)
    {
        const int width = y < expected.height ? expected.width : 0;
        if (width > 0)
        {
            FadeRow(expected.Pixel(0, y), row.data(), width);
        }
        picture.rgba.insert(picture.rgba.end(), row.begin(), row.end());
    }
    PaintMarks(picture, marks);
    if (marks.over.x1 >= 0)
    {
        PaintBox(picture, marks.over);
    }
    return picture;
}

Frame SideBySide(const Frame& expected, const Frame& actual, const Frame& difference)
{
    const int height = std::max({expected.height, actual.height, difference.height});
    // Columns have the width of the widest, so that equal positions are easy to find.
    const int column = std::max({expected.width, actual.width, difference.width});
    Frame picture(3 * column + 2 * kSeparatorWidth, height);
    FillRect(picture, 0, 0, picture.width, picture.height, kSeparator);
    Paste(expected, picture, 0);
    Paste(actual, picture, column + kSeparatorWidth);
    Paste(difference, picture, 2 * (column + kSeparatorWidth));
    return picture;
}

} // namespace boxreel
