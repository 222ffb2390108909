// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

#include <cmath>

/// @file
/// Functions of single numbers, for b2Math.h and everything above it. Only IEEE basic operations
/// and square roots are used, with sine, cosine and arc tangent of our own, so every compiler and
/// C library gives the same bits.

namespace box2d
{
/// Sine and cosine of an angle [rad]. The single-precision form is correct to 0.51 ulp, the double
/// form to 3 ulp, for angles to a million; beyond, the error grows with the angle. An angle of zero
/// gives exactly 0 and 1; one that is not finite gives NaN.
void SinCos(float angle, float* sine, float* cosine);
void SinCos(double angle, double* sine, double* cosine);

/// The angle of the vector (x, y), from -pi to pi, to 3 ulp, with the signs and special cases of
/// std::atan2.
double Atan2(double y, double x);
} // namespace box2d

/// False for NaN and the infinities.
inline bool b2IsValid(float32 x)
{
    return std::isfinite(x);
}

/// The square root, rounded correctly; NaN below 0.
inline float32 b2Sqrt(float32 x)
{
    return std::sqrt(x);
}

/// 1 / sqrt(x), correct to one rounding of each: there is no approximation to be hidden here.
inline float32 b2InvSqrt(float32 x)
{
    return 1.0f / std::sqrt(x);
}

/// The angle of the vector (x, y) [rad], from -pi to pi.
inline float32 b2Atan2(float32 y, float32 x)
{
    return static_cast<float32>(box2d::Atan2(y, x));
}

/// Without its sign.
template <typename T>
constexpr T b2Abs(T a)
{
    return a > T(0) ? a : -a;
}

/// So that -0 becomes 0 and NaN stays what it is.
inline float32 b2Abs(float32 a)
{
    return std::fabs(a);
}

/// The smaller one; b when one is NaN.
template <typename T>
constexpr T b2Min(T a, T b)
{
    return a < b ? a : b;
}

/// The larger one; b when one is NaN.
template <typename T>
constexpr T b2Max(T a, T b)
{
    return a > b ? a : b;
}

/// What is nearest to a from low to high.
template <typename T>
constexpr T b2Clamp(T a, T low, T high)
{
    return b2Max(low, b2Min(a, high));
}

/// Each gets the value of the other.
template <typename T>
constexpr void b2Swap(T& a, T& b)
{
    T c = a;
    a = b;
    b = c;
}

/// Whether x is 1, 2, 4, ...; 0 is none.
constexpr bool b2IsPowerOfTwo(uint32 x)
{
    return x != 0 && (x & (x - 1)) == 0;
}

/// The smallest power of two above x: 1 for 0, 8 for 4 to 7; 0 when there is none in 32 bits.
constexpr uint32 b2NextPowerOfTwo(uint32 x)
{
    uint32 power = 1;
    while (power != 0 && power <= x)
    {
        power <<= 1;
    }
    return power;
}
