// SPDX-License-Identifier: MIT
#include "EdgeRule.h"
#include "Lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace boxreel
{

namespace
{

// Squares and products of bytes, and sums of four, are whole numbers below 2^24 and exact in a
// float. What is divided is off by a rounding or two: a square of at most 4 * 255^2 by less than
// 0.1, and its root by sqrt(0.1); two of these are compared.
constexpr float kOffMargin = 0.7f;    // [steps of a channel]
constexpr float kMovedMargin = 1e-5f; // a share

using Channels = std::array<Floats, 4>;

Channels Split(Words pixels)
{
    return {ToFloats(pixels & 255u), ToFloats(pixels >> 8 & 255u), ToFloats(pixels >> 16 & 255u),
            ToFloats(pixels >> 24)};
}

Floats Dot(const Channels& a, const Channels& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Channels Minus(const Channels& a, const Channels& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}

Words Load(const std::uint8_t* pixels)
{
    Words words;
    std::memcpy(&words, pixels, sizeof words);
    return words;
}

// Of four pixels that stand in a row, the nine around each, in the order in which EdgeExplains
// looks at them.
struct Around
{
    std::array<Channels, 9> pixels;
};

// The first of those that are farthest from `from`.
Channels Farthest(const Around& around, const Channels& from)
{
    Channels farthest = from;
    Floats largest = Splat(0.0f);
    for (const Channels& pixel : around.pixels)
    {
        const Channels difference = Minus(pixel, from);
        const Floats squared = Dot(difference, difference);
        const Masks isFarther = squared > largest;
        largest = isFarther ? squared : largest;
        for (std::size_t c = 0; c < 4; ++c)
        {
            farthest[c] = isFarther ? pixel[c] : farthest[c];
        }
    }
    return farthest;
}

// The largest square of the distance from the line through `one` along `span`.
Floats OffSquared(const Channels& pixel, const Channels& one, const Channels& span,
                  Floats spanSquared)
{
    const Channels d = Minus(pixel, one);
    const Floats along = Dot(d, span);
    return Dot(d, d) - along * along / spanSquared;
}

// What EdgeExplains says of each of four pixels, where rounding cannot matter.
struct Answers
{
    Masks mayBe; // else certainly not
    Masks isSo;  // certainly
};

// `steps`, `shift`: as EdgeExplains has them.
Answers Judge(const Around& around, Words actual, Masks isOver, float steps, float shift)
{
    const Channels one = Farthest(around, around.pixels[0]);
    const Channels span = Minus(Farthest(around, one), one);
    const Floats spanSquared = Dot(span, span);
    const Channels color = Split(actual);
    // |moved| <= 2 shift + steps / |span|, times |span|^2, and squared without its first part.
    const Floats along = Magnitude(Dot(Minus(color, around.pixels[0]), span));
    const Floats beyond = along - Splat(2.0f * shift) * spanSquared;
    const Floats margin = Splat(kMovedMargin) * (along + spanSquared);
    const Floats allowed = Splat(steps * steps) * spanSquared;
    const Floats most = beyond + margin, least = beyond - margin;
    Answers answers;
    answers.mayBe =
        isOver & (spanSquared > 0.0f) & ((least <= 0.0f) | (least * least <= allowed * 1.00001f));
    answers.isSo = answers.mayBe & ((most < 0.0f) | (most * most < allowed * 0.99999f));
    if (!Any(answers.mayBe))
    {
        return answers;
    }
    const Floats divisor = Larger(spanSquared, Splat(1.0f));
    Floats thick = Splat(0.0f);
    for (const Channels& pixel : around.pixels)
    {
        thick = Larger(thick, OffSquared(pixel, one, span, divisor));
    }
    const Floats off = Larger(OffSquared(color, one, span, divisor), Splat(0.0f));
    for (int i = 0; i < kLanes; ++i)
    {
        const float excess = std::sqrt(off[i]) - std::sqrt(thick[i]) - steps;
        answers.mayBe[i] &= -std::int32_t(excess <= kOffMargin);
        answers.isSo[i] &= -std::int32_t(excess < -kOffMargin);
    }
    return answers;
}

// The rows above, at and below the pixels that are judged, from one column before the first to one
// after the last. At a border they are a copy, with the border's pixels again where there are none:
// that adds no colour and changes no order.
class ThreeRows
{
public:
    ThreeRows(const Frame& frame, int x, int y)
    {
        const bool isInside = x > 0 && x + kLanes < frame.width;
        for (int r = 0; r < 3; ++r)
        {
            const int v = std::clamp(y + r - 1, 0, frame.height - 1);
            for (int i = 0; i < kWidth && !isInside; ++i)
            {
                const int u = std::clamp(x - 1 + i, 0, frame.width - 1);
                std::memcpy(&m_copies[r][4 * i], frame.Pixel(u, v), 4);
            }
            m_rows[r] = isInside ? frame.Pixel(x - 1, v) : m_copies[r];
        }
    }

    // Four pixels, of which the first is one of three.
    Words At(int r, int x) const { return Load(m_rows[r] + 4 * x); }

    bool IsFlat() const
    {
        const Words first = At(0, 0);
        Words different = first ^ first[0];
        for (int r = 0; r < 3; ++r)
        {
            different |= (At(r, 0) ^ first[0]) | (At(r, 2) ^ first[0]);
        }
        return !Any(std::bit_cast<Masks>(different));
    }

private:
    static constexpr int kWidth = kLanes + 2;
    const std::uint8_t* m_rows[3];
    std::uint8_t m_copies[3][4 * kWidth];
};

Around Split(const ThreeRows& rows)
{
    Around around;
    around.pixels[0] = Split(rows.At(1, 1));
    std::size_t count = 1;
    for (int i = 0; i < 9; ++i)
    {
        if (i != 4)
        {
            around.pixels[count++] = Split(rows.At(i / 3, i % 3));
        }
    }
    return around;
}

// Whether `count` pixels and all around them are of one colour. False at the picture's border.
bool IsFlat(const Frame& frame, int x, int y, int count)
{
    if (x == 0 || y == 0 || x + count >= frame.width || y + 1 >= frame.height)
    {
        return false;
    }
    const std::uint8_t* row = frame.Pixel(x - 1, y);
    const std::size_t bytes = std::size_t(count + 2) * 4;
    return std::memcmp(row, row + 4, bytes - 4) == 0 &&
           std::memcmp(row, frame.Pixel(x - 1, y - 1), bytes) == 0 &&
           std::memcmp(row, frame.Pixel(x - 1, y + 1), bytes) == 0;
}

} // namespace

std::int64_t ExcuseEdges(const Frame& expected, const Frame& actual, int y, int begin, int end,
                         double tolerance, double shift, Mark* row)
{
    std::int64_t excused = 0;
    const float steps = float(255.0 * std::sqrt(3.0) * tolerance);
    constexpr int kRun = 32; // flat areas are wide
    for (int x = begin; x < end; x += kLanes)
    {
        if ((x - begin) % kRun == 0 && x + kRun <= end && IsFlat(expected, x, y, kRun))
        {
            x += kRun - kLanes;
            continue;
        }
        const int count = std::min(kLanes, end - x);
        Mark* const marks = row + x;
        Masks isOver{};
        for (int i = 0; i < count; ++i)
        {
            isOver[i] = -std::int32_t(marks[i] == Mark::Over);
        }
        if (!Any(isOver))
        {
            continue;
        }
        const ThreeRows rows(expected, x, y);
        if (rows.IsFlat())
        {
            continue;
        }
        std::uint8_t colors[4 * kLanes] = {};
        std::memcpy(colors, actual.Pixel(x, y), std::size_t(count) * 4);
        const Answers answers = Judge(Split(rows), Load(colors), isOver, steps, float(shift));
        for (int i = 0; i < count && Any(answers.mayBe); ++i)
        {
            if (answers.mayBe[i] != 0 &&
                (answers.isSo[i] != 0 ||
                 EdgeExplains(expected, x + i, y, actual.Pixel(x + i, y), tolerance, shift)))
            {
                marks[i] = Mark::Within;
                ++excused;
            }
        }
    }
    return excused;
}

} // namespace boxreel
