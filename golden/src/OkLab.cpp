// SPDX-License-Identifier: MIT
#include "OkLab.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace boxreel
{

namespace
{

// Returns s^(1/5) for s in (0, 1], by Newton's method on r^5 - s = 0. From r = 1 the values
// decrease towards the root, first by at least a fifth per step, then quadratically. 60 steps
// suffice for the smallest s.
constexpr double FifthRoot(double s)
{
    double r = 1.0;
    for (int i = 0; i < 60; ++i)
    {
        const double r4 = r * r * r * r;
        r -= (r4 * r - s) / (5.0 * r4);
    }
    return r;
}

// IEC 61966-2-1: linear light of an 8-bit sRGB value; x^2.4 = x^2 (x^2)^(1/5).
constexpr std::array<double, 256> MakeLinearLight()
{
    std::array<double, 256> table{};
    for (int i = 0; i < 256; ++i)
    {
        const double value = i / 255.0;
        const double x = (value + 0.055) / 1.055;
        table[static_cast<std::size_t>(i)] =
            value <= 0.04045 ? value / 12.92 : x * x * FifthRoot(x * x);
    }
    return table;
}

constexpr std::array<double, 256> kLinearLight = MakeLinearLight();

// Returns x^(1/3) for normal x >= 0. A third of the bits is a third of the exponent: an estimate
// within 7 % (682 is two thirds of the exponent's bias). A step of Halley's method on r^3 - x = 0
// reduces a relative error e to about 2/3 e^3, so two leave less than 1e-10, far below any
// tolerance. A fixed number of steps without library calls gives the same bits everywhere.
double CubeRoot(double x)
{
    if (x <= 0.0)
    {
        return 0.0;
    }
    double r = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 +
                                     (static_cast<std::uint64_t>(682) << 52));
    for (int i = 0; i < 2; ++i)
    {
        const double r3 = r * r * r;
        r *= (r3 + 2.0 * x) / (2.0 * r3 + x);
    }
    return r;
}

// Contribution of a channel's value to the three cone responses. 1e-30 avoids a division by zero
// for black without changing other values.
struct ConeShares
{
    alignas(16) float channels[3][256][kLanes];
};

constexpr ConeShares MakeConeShares()
{
    constexpr double kShares[3][3] = {{0.4122214708, 0.2119034982, 0.0883024619},
                                      {0.5363325363, 0.6806995451, 0.2817188376},
                                      {0.0514459929, 0.1073969566, 0.6299787005}};
    ConeShares shares{};
    for (int channel = 0; channel < 3; ++channel)
    {
        for (int value = 0; value < 256; ++value)
        {
            for (int cone = 0; cone < 3; ++cone)
            {
                shares.channels[channel][value][cone] =
                    float(kShares[channel][cone] * kLinearLight[std::size_t(value)] + 1e-30);
            }
            shares.channels[channel][value][3] = 1.0f;
        }
    }
    return shares;
}

constexpr ConeShares kConeShares = MakeConeShares();

// Same as CubeRoot, in floats. The estimate is within 3.5 %, because its constant minimizes the
// maximum error. One step reduces that to 3e-5.
Floats NearlyCubeRoot(Floats x)
{
    const Floats bits = ToFloats(std::bit_cast<Masks>(x));
    const Floats guess = bits * (1.0f / 3.0f) + 709965728.0f;
    const Floats r = std::bit_cast<Floats>(__builtin_convertvector(guess, Masks));
    const Floats r3 = r * r * r;
    return r * (r3 + 2.0f * x) / (2.0f * r3 + x);
}

Floats ConeShare(int channel, std::uint32_t value)
{
    Floats share;
    std::memcpy(&share, kConeShares.channels[channel][value], sizeof share);
    return share;
}

// Returns the cube roots of the cone responses of a pixel.
Floats NearlyCones(std::uint32_t pixel)
{
    std::uint8_t bytes[4];
    std::memcpy(bytes, &pixel, 4);
    return NearlyCubeRoot(ConeShare(0, bytes[0]) + ConeShare(1, bytes[1]) + ConeShare(2, bytes[2]));
}

Floats NearlyDistanceOnBlack(Words p, Words q)
{
    const Floats d0 = NearlyCones(p[0]) - NearlyCones(q[0]);
    const Floats d1 = NearlyCones(p[1]) - NearlyCones(q[1]);
    const Floats d2 = NearlyCones(p[2]) - NearlyCones(q[2]);
    const Floats d3 = NearlyCones(p[3]) - NearlyCones(q[3]);
    const Floats lm01 = __builtin_shufflevector(d0, d1, 0, 4, 1, 5);
    const Floats lm23 = __builtin_shufflevector(d2, d3, 0, 4, 1, 5);
    const Floats s01 = __builtin_shufflevector(d0, d1, 2, 6, 2, 6);
    const Floats s23 = __builtin_shufflevector(d2, d3, 2, 6, 2, 6);
    const Floats l = __builtin_shufflevector(lm01, lm23, 0, 1, 4, 5);
    const Floats m = __builtin_shufflevector(lm01, lm23, 2, 3, 6, 7);
    const Floats s = __builtin_shufflevector(s01, s23, 0, 1, 4, 5);
    const Floats lightness = 0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s;
    const Floats a = 1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s;
    const Floats b = 0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s;
    return Root(lightness * lightness + a * a + b * b);
}

std::uint8_t OnWhite(std::uint8_t premultiplied, std::uint8_t alpha)
{
    return static_cast<std::uint8_t>(std::min(255, premultiplied + 255 - alpha));
}

} // namespace

// B. Ottosson, "A perceptual color space for image processing", 2020:
// linear sRGB -> cone responses -> cube roots -> lightness and two opponent axes.
OkLab ToOkLab(std::uint8_t red, std::uint8_t green, std::uint8_t blue)
{
    const double r = kLinearLight[red];
    const double g = kLinearLight[green];
    const double b = kLinearLight[blue];
    const double l = CubeRoot(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = CubeRoot(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = CubeRoot(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double Distance(const OkLab& p, const OkLab& q)
{
    const double dl = p.lightness - q.lightness;
    const double da = p.a - q.a;
    const double db = p.b - q.b;
    return std::sqrt(dl * dl + da * da + db * db);
}

double PixelDistance(const std::uint8_t* p, const std::uint8_t* q)
{
    const double onBlack = Distance(ToOkLab(p[0], p[1], p[2]), ToOkLab(q[0], q[1], q[2]));
    if (p[3] == 255 && q[3] == 255)
    {
        return onBlack;
    }
    const double onWhite =
        Distance(ToOkLab(OnWhite(p[0], p[3]), OnWhite(p[1], p[3]), OnWhite(p[2], p[3])),
                 ToOkLab(OnWhite(q[0], q[3]), OnWhite(q[1], q[3]), OnWhite(q[2], q[3])));
    return std::max(onBlack, onWhite);
}

Floats NearlyPixelDistance(Words p, Words q)
{
    const Floats onBlack = NearlyDistanceOnBlack(p, q);
    Words opaque = p & q;
    std::uint8_t alphas[4 * kLanes];
    std::memcpy(alphas, &opaque, sizeof alphas);
    if ((alphas[3] & alphas[7] & alphas[11] & alphas[15]) == 255)
    {
        return onBlack;
    }
    std::uint8_t bytes[2][4 * kLanes];
    std::memcpy(bytes[0], &p, sizeof p);
    std::memcpy(bytes[1], &q, sizeof q);
    for (auto& pixels : bytes)
    {
        for (int i = 0; i < 4 * kLanes; ++i)
        {
            pixels[i] = i % 4 == 3 ? pixels[i] : OnWhite(pixels[i], pixels[i | 3]);
        }
    }
    std::memcpy(&p, bytes[0], sizeof p);
    std::memcpy(&q, bytes[1], sizeof q);
    return Larger(onBlack, NearlyDistanceOnBlack(p, q));
}

} // namespace boxreel
