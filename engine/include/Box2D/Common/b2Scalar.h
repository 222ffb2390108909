// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

#include <cmath>

/// @file
/// Scalar functions. Only IEEE basic operations and square roots are used, with our own sine,
/// cosine and arc tangent. Every compiler and C library therefore gives the same bits.

namespace box2d
{
/// Returned in registers: by two pointers they would be written and read again at once.
template <class T>
struct SineCosine
{
    T sine, cosine;
};

/// Returns sine and cosine of an angle [rad]. For angles up to a million, the single-precision
/// form is correct to 0.51 ulp and the double form to 3 ulp. Beyond, the error grows with the
/// angle. Zero gives exactly 0 and 1; an angle that is not finite gives NaN.
SineCosine<float> SinCos(float angle);
SineCosine<double> SinCos(double angle);

/// Returns the angle of the vector (x, y) [rad], -pi to pi, to 3 ulp. Signs and special cases are
/// those of std::atan2.
double Atan2(double y, double x);
} // namespace box2d

/// False for NaN and the infinities.
inline bool b2IsValid(float32 x)
{
    return std::isfinite(x);
}

/// Returns the square root, rounded correctly; NaN below 0.
inline float32 b2Sqrt(float32 x)
{
    return std::sqrt(x);
}

/// Returns 1 / sqrt(x), computed with two correct roundings.
inline float32 b2InvSqrt(float32 x)
{
    return 1.0f / std::sqrt(x);
}

/// Returns the angle of the vector (x, y) [rad], -pi to pi.
inline float32 b2Atan2(float32 y, float32 x)
{
    return static_cast<float32>(box2d::Atan2(y, x));
}

/// Returns the absolute value.
template <typename T>
constexpr T b2Abs(T a)
{
    return a > T(0) ? a : -a;
}

/// Returns the absolute value; -0 becomes 0, NaN stays NaN.
inline float32 b2Abs(float32 a)
{
    return std::fabs(a);
}

/// Returns the minimum; b when one is NaN.
template <typename T>
constexpr T b2Min(T a, T b)
{
    return a < b ? a : b;
}

/// Returns the maximum; b when one is NaN.
template <typename T>
constexpr T b2Max(T a, T b)
{
    return a > b ? a : b;
}

/// Clamps a to [low, high].
template <typename T>
constexpr T b2Clamp(T a, T low, T high)
{
    return b2Max(low, b2Min(a, high));
}

/// Exchanges the values.
template <typename T>
constexpr void b2Swap(T& a, T& b)
{
    T c = a;
    a = b;
    b = c;
}

/// True if x is a power of two; false for 0.
constexpr bool b2IsPowerOfTwo(uint32 x)
{
    return x != 0 && (x & (x - 1)) == 0;
}

/// Returns the smallest power of two above x: 1 for 0, 8 for 4 to 7; 0 on overflow.
constexpr uint32 b2NextPowerOfTwo(uint32 x)
{
    uint32 power = 1;
    while (power != 0 && power <= x)
    {
        power <<= 1;
    }
    return power;
}
