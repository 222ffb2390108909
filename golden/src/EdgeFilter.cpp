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

// Squares and products of bytes, and sums of four, are integers below 2^24 and exact in a float.
// Divisions add one or two rounding errors: less than 0.1 for a square of at most 4 * 255^2, and
// sqrt(0.1) for its root. Two of these are compared.
constexpr float kOffMargin = 0.7f;    // [steps of a channel]
constexpr float kMovedMargin = 1e-5f; // a fraction

// Red with blue and green with alpha, 16 bits each, for four pixels or their differences.
struct Channels
{
    Masks redBlue;
    Masks greenAlpha;
};

Channels Split(Words pixels)
{
    return {std::bit_cast<Masks>(pixels & 0x00ff00ffu),
            std::bit_cast<Masks>(pixels >> 8 & 0x00ff00ffu)};
}

Masks Dot(const Channels& a, const Channels& b)
{
    return PairDot(a.redBlue, b.redBlue) + PairDot(a.greenAlpha, b.greenAlpha);
}

Channels Minus(const Channels& a, const Channels& b)
{
    return {PairMinus(a.redBlue, b.redBlue), PairMinus(a.greenAlpha, b.greenAlpha)};
}

Words Load(const std::uint8_t* pixels)
{
    Words words;
    std::memcpy(&words, pixels, sizeof words);
    return words;
}

// The nine pixels around each of four pixels in a row, in the order of EdgeExplains: the centre
// first.
struct Around
{
    std::array<Words, 9> pixels;
    std::array<Channels, 9> channels;

    void Set(std::size_t index, Words words)
    {
        pixels[index] = words;
        channels[index] = Split(words);
    }

    // Returns the first of those furthest from `from`.
    Words Farthest(Words from) const
    {
        const Channels origin = Split(from);
        Words farthest = from;
        Masks largest{};
        for (std::size_t i = 0; i < 9; ++i)
        {
            const Channels difference = Minus(channels[i], origin);
            const Masks squared = Dot(difference, difference);
            const Masks isFarther = squared > largest;
            farthest = isFarther ? pixels[i] : farthest;
            largest = isFarther ? squared : largest;
        }
        return farthest;
    }
};

// The two ends of the blends of each pixel, as in EdgeExplains.
struct Blends
{
    Channels one;
    Channels span;
    Floats spanSquared;

    // Returns the squared distance from the line through both.
    Floats OffSquared(const Channels& pixel) const
    {
        const Channels d = Minus(pixel, one);
        const Floats along = ToFloats(Dot(d, span));
        return Larger(ToFloats(Dot(d, d)) - along * along / spanSquared, Splat(0.0f));
    }
};

// The results of EdgeExplains for four pixels, as far as rounding cannot change them.
struct Answers
{
    Masks mayBe; // unset: certainly not
    Masks isSo;  // certainly
};

// Tests if the colour is a blend of its neighbourhood. `answers` are those of the other test.
void JudgeOff(const Around& around, const Blends& blends, const Channels& color, float steps,
              Answers& answers)
{
    const Floats off = blends.OffSquared(color);
    const float close = std::max(steps - kOffMargin, 0.0f);
    const Masks isClose = off < close * close;
    if (!Any(answers.mayBe & ~isClose))
    {
        return;
    }
    Floats thick = Splat(0.0f);
    for (const Channels& pixel : around.channels)
    {
        thick = Larger(thick, blends.OffSquared(pixel));
    }
    const Floats excess = Root(off) - Root(thick) - steps;
    answers.mayBe &= excess <= kOffMargin;
    answers.isSo &= isClose | (excess < -kOffMargin);
}

// `steps`, `shift`: as in EdgeExplains.
Answers Judge(const Around& around, Words actual, Masks isOver, float steps, float shift)
{
    const Words first = around.Farthest(around.pixels[0]);
    const Channels one = Split(first);
    const Channels span = Minus(Split(around.Farthest(first)), one);
    const Floats spanSquared = ToFloats(Dot(span, span));
    const Channels color = Split(actual);
    // |moved| <= 2 shift + steps / |span|, times |span|^2, and squared without its first part.
    const Floats along = Magnitude(ToFloats(Dot(Minus(color, around.channels[0]), span)));
    const Floats beyond = along - 2.0f * shift * spanSquared;
    const Floats margin = kMovedMargin * (along + spanSquared);
    const Floats allowed = steps * steps * spanSquared;
    const Floats maximum = beyond + margin, minimum = beyond - margin;
    Answers answers{};
    answers.mayBe = isOver & (spanSquared > 0.0f) &
                    ((minimum <= 0.0f) | (minimum * minimum <= allowed * 1.00001f));
    if (Any(answers.mayBe))
    {
        answers.isSo =
            answers.mayBe & ((maximum < 0.0f) | (maximum * maximum < allowed * 0.99999f));
        JudgeOff(around, {one, span, Larger(spanSquared, Splat(1.0f))}, color, steps, answers);
    }
    return answers;
}

// The rows above, at and below the tested pixels, with one more column on either side. At a border
// they are a copy that repeats the border's pixels, which adds no colour and keeps the order.
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

    // Loads four pixels of one of the three rows.
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
    around.Set(0, rows.At(1, 1));
    std::size_t count = 1;
    for (int i = 0; i < 9; ++i)
    {
        if (i != 4)
        {
            around.Set(count++, rows.At(i / 3, i % 3));
        }
    }
    return around;
}

// True if `count` pixels and their neighbours have one colour. False at the picture's border.
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

int ExcuseEdges(const Frame& expected, const Frame& actual, int y, int begin, int end,
                double tolerance, double shift, Mark* row)
{
    int excused = 0;
    const float steps = float(255.0 * std::sqrt(3.0) * tolerance);
    constexpr int kRun = 32; // typical width of flat areas
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
