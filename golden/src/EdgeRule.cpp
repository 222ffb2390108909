// SPDX-License-Identifier: MIT
#include "EdgeRule.h"

#include "PixelWord.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace boxreel
{

namespace
{

// A pixel is the mean of its area, so an edge that moves by d changes it by at most d times the
// contrast C of the two sides. The mean is over bytes, so the change is measured in bytes; OKLab is
// not linear near black.
// The largest difference in 3 x 3 pixels shows C. A line of one pixel between two rows is an
// exception: each row is half line, half background, so only half of C is visible. Twice the
// fraction covers both. It accepts a plain step that moves by up to 2 d, and a missing line from d
// = 0.5 on.
constexpr double kOfOnePixelLine = 2.0;

using Bytes = std::array<double, 4>;

Bytes Load(const std::uint8_t* p)
{
    return {double(p[0]), double(p[1]), double(p[2]), double(p[3])};
}

double Dot(const Bytes& a, const Bytes& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Bytes Minus(const Bytes& a, const Bytes& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}

// The line of colours from `from` to `from + span`: all blends of the two.
struct Blend
{
    Bytes from;
    Bytes span;

    // Returns the parameter of the nearest blend: 0 at one end, 1 at the other.
    double Share(const Bytes& color) const
    {
        return Dot(Minus(color, from), span) / Dot(span, span);
    }

    // Returns the distance of the colour from the nearest blend [steps of a channel].
    double Off(const Bytes& color) const
    {
        const Bytes d = Minus(color, from);
        const double along = Dot(d, span);
        return std::sqrt(std::max(0.0, Dot(d, d) - along * along / Dot(span, span)));
    }
};

// The existing pixels of 3 x 3; the first is the centre.
struct Neighbourhood
{
    std::array<std::uint32_t, 9> pixels;
    std::size_t count = 0;
    bool isFlat = true; // all equal
};

Neighbourhood Around(const Frame& frame, int x, int y)
{
    Neighbourhood around;
    const std::uint32_t middle = PixelWord(frame.Pixel(x, y));
    around.pixels[around.count++] = middle;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, frame.height - 1); ++v)
    {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, frame.width - 1); ++u)
        {
            const std::uint32_t pixel = PixelWord(frame.Pixel(u, v));
            if (pixel != middle)
            {
                around.pixels[around.count++] = pixel;
                around.isFlat = false;
            }
        }
    }
    return around;
}

Bytes BytesOf(std::uint32_t word)
{
    std::uint8_t bytes[4];
    std::memcpy(bytes, &word, 4);
    return Load(bytes);
}

int SquaredSteps(std::uint32_t p, std::uint32_t q)
{
    int sum = 0;
    for (int shift = 0; shift < 32; shift += 8)
    {
        const int d = int(p >> shift & 255u) - int(q >> shift & 255u);
        sum += d * d;
    }
    return sum;
}

std::uint32_t Farthest(const Neighbourhood& around, std::uint32_t from)
{
    std::uint32_t farthest = from;
    int largest = 0;
    for (std::size_t i = 0; i < around.count; ++i)
    {
        const int squared = SquaredSteps(from, around.pixels[i]);
        if (squared > largest)
        {
            largest = squared;
            farthest = around.pixels[i];
        }
    }
    return farthest;
}

} // namespace

bool EdgeExplains(const Frame& expected, int x, int y, const std::uint8_t* actual, double tolerance,
                  double shift)
{
    const Neighbourhood around = Around(expected, x, y);
    if (around.isFlat)
    {
        return false;
    }
    // The furthest from the furthest: for blends of two colours these are the two ends.
    const std::uint32_t one = Farthest(around, around.pixels[0]);
    const Bytes from = BytesOf(one);
    const Blend blend{from, Minus(BytesOf(Farthest(around, one)), from)};
    // Black to white is 1 in OKLab, and 255 sqrt(3) here.
    const double steps = 255.0 * std::sqrt(3.0) * tolerance;
    const Bytes color = Load(actual);
    const double moved = blend.Share(color) - blend.Share(BytesOf(around.pixels[0]));
    if (std::abs(moved) > kOfOnePixelLine * shift + steps / std::sqrt(Dot(blend.span, blend.span)))
    {
        return false;
    }
    // An unrelated colour is not a blend. Where three colours meet, the expected pixels are off the
    // line of two of them, and so may this one be.
    double thickness = 0.0;
    for (std::size_t i = 0; i < around.count; ++i)
    {
        thickness = std::max(thickness, blend.Off(BytesOf(around.pixels[i])));
    }
    return blend.Off(color) <= thickness + steps;
}

} // namespace boxreel
