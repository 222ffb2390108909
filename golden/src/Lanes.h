// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

/// Vectors of four numbers, by the vector types of gcc and clang, available on all their processors
/// and at any level of optimization. For the filters of the comparison, which decide clear cases
/// and leave the rest to scalar code.
namespace boxreel
{

inline constexpr int kLanes = 4;
using Floats = float __attribute__((vector_size(16)));
using Words = std::uint32_t __attribute__((vector_size(16)));
using Masks = std::int32_t __attribute__((vector_size(16))); ///< result of a comparison: -1 or 0

inline Floats Splat(float value)
{
    return Floats{value, value, value, value};
}

inline Floats ToFloats(Masks whole)
{
    return __builtin_convertvector(whole, Floats);
}

inline Floats Larger(Floats a, Floats b)
{
    return a > b ? a : b;
}

inline Floats Magnitude(Floats a)
{
    return Larger(a, -a);
}

inline Floats Root(Floats a)
{
    return Floats{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}

/// Returns the dot product of signed 16-bit halves between -256 and 256: the sum of lower and upper
/// products.
inline Masks PairDot(Masks a, Masks b)
{
#ifdef __SSE2__
    return std::bit_cast<Masks>(
        _mm_madd_epi16(std::bit_cast<__m128i>(a), std::bit_cast<__m128i>(b)));
#else
    return (a << 16 >> 16) * (b << 16 >> 16) + (a >> 16) * (b >> 16);
#endif
}

/// Subtracts 16-bit halves separately.
inline Masks PairMinus(Masks a, Masks b)
{
    using Halves = std::int16_t __attribute__((vector_size(16)));
    return std::bit_cast<Masks>(std::bit_cast<Halves>(a) - std::bit_cast<Halves>(b));
}

inline bool Any(Masks mask)
{
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

} // namespace boxreel
