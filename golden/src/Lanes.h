// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// Four numbers at once, by the vector types that gcc and clang share: every processor of theirs
/// has such operations, and at any level of optimisation they are used. For the filters of the
/// comparison, which decide what is clear and leave the rest to plain code.
namespace boxreel
{

inline constexpr int kLanes = 4;
using Floats = float __attribute__((vector_size(16)));
using Words = std::uint32_t __attribute__((vector_size(16)));
using Masks = std::int32_t __attribute__((vector_size(16))); ///< of a comparison: -1 or 0

inline Floats Splat(float value)
{
    return Floats{value, value, value, value};
}

inline Floats ToFloats(Words small) ///< below 2^31
{
    return __builtin_convertvector(std::bit_cast<Masks>(small), Floats);
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

inline bool Any(Masks mask)
{
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

} // namespace boxreel
