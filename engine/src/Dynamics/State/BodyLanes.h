// SPDX-License-Identifier: MIT
#pragma once

#include "Solver.h"

#include "../../Common/Simd.h"

#include <Box2D/Common/b2Settings.h>

#include <cstring>
#include <limits>

/// Bodies and vectors in lanes, for numbers F of 4, 8 or 16: the base of all solvers on blocks. It
/// has no external linkage, because sources of every instruction set include it.
namespace box2d
{
namespace
{

/// Number of floats from one body to the next.
constexpr int kBodyStride = int(sizeof(SolverBody) / sizeof(float32));

template <class F>
struct Vector
{
    F x, y;
};

template <class F>
Vector<F> operator+(const Vector<F>& u, const Vector<F>& v)
{
    return {u.x + v.x, u.y + v.y};
}
template <class F>
Vector<F> operator-(const Vector<F>& u, const Vector<F>& v)
{
    return {u.x - v.x, u.y - v.y};
}
template <class F>
Vector<F> operator-(const Vector<F>& v)
{
    return {-v.x, -v.y};
}
template <class F>
Vector<F> operator*(F s, const Vector<F>& v)
{
    return {s * v.x, s * v.y};
}
template <class F>
F Dot(const Vector<F>& u, const Vector<F>& v)
{
    return u.x * v.x + u.y * v.y;
}
template <class F>
F Cross(const Vector<F>& u, const Vector<F>& v)
{
    return u.x * v.y - u.y * v.x;
}
/// Returns (0, 0, s) x v: the velocity of a point at v with the angular velocity s.
template <class F>
Vector<F> Cross(F s, const Vector<F>& v)
{
    return {-s * v.y, s * v.x};
}
/// Returns (0, 0, 1) x v.
template <class F>
Vector<F> Skew(const Vector<F>& v)
{
    return {-v.y, v.x};
}
template <class M, class F>
Vector<F> Select(M which, const Vector<F>& yes, const Vector<F>& no)
{
    return {Select(which, yes.x, no.x), Select(which, yes.y, no.y)};
}
template <class F>
F Length(const Vector<F>& v)
{
    return Sqrt(Dot(v, v));
}
/// True if |v| <= length.
template <class F>
auto LengthIsWithin(const Vector<F>& v, F length)
{
    return AtLeast(length * length, Dot(v, v));
}
template <class F>
F Clamp(F value, F low, F high)
{
    return Max(low, Min(value, high));
}
template <class F>
F Abs(F value)
{
    return Max(value, -value);
}
/// True if a < b; false if either is NaN.
template <class F>
auto Less(F a, F b)
{
    return And(AtLeast(b, a), Not(AtLeast(a, b)));
}
/// Returns 1 / value, or 0 for value <= 0.
template <class F>
F InverseOrZero(F value)
{
    const auto positive = AtLeast(value, F::Set(std::numeric_limits<float32>::denorm_min()));
    return Select(positive, F::Set(1.0f) / Select(positive, value, F::Set(1.0f)), F::Set(0.0f));
}
/// Returns 1 / value, or 0 for 0.
template <class F>
F InverseUnlessZero(F value)
{
    const F zero = F::Set(0.0f);
    const auto isZero = And(AtLeast(value, zero), AtLeast(zero, value));
    return Select(isZero, zero, F::Set(1.0f) / Select(isZero, F::Set(1.0f), value));
}
/// Normalizes the vector and returns the former length. A vector shorter than b2_epsilon is
/// unchanged, and the result is 0.
template <class F>
F Normalize(Vector<F>& v)
{
    const F length = Sqrt(Dot(v, v));
    const auto hasDirection = AtLeast(length, F::Set(b2_epsilon));
    const F inverse = F::Set(1.0f) / Select(hasDirection, length, F::Set(1.0f));
    v = Select(hasDirection, inverse * v, v);
    return Select(hasDirection, length, F::Set(0.0f));
}
/// The same, but (1, 0) for a vector without a direction.
template <class F>
F NormalizeOrX(Vector<F>& v)
{
    const F length = Normalize(v);
    const auto hasDirection = AtLeast(length, F::Set(b2_epsilon));
    v = Select(hasDirection, v, Vector<F>{F::Set(1.0f), F::Set(0.0f)});
    return length;
}
template <class F>
Vector<F> Turn(F sine, F cosine, const Vector<F>& v)
{
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
}

/// Writes the rows of the bodies that can move, given by the bit mask `moves`. Others may be shared
/// by several contacts of a colour.
template <class F>
BOX2D_INLINE void StoreMoved(float32* base, const int32* bodies, uint32 moves, const F (&rows)[4])
{
    constexpr uint32 all = (1u << F::kLanes) - 1u;
    if ((moves & all) == all)
    {
        StoreRows(base, kBodyStride, bodies, rows);
        return;
    }
    static constexpr int32 order[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    float32 lanes[4 * F::kLanes];
    StoreRows(lanes, 4, order, rows);
    for (int i = 0; i < F::kLanes; ++i)
    {
        if ((moves >> i & 1u) != 0)
        {
            std::memcpy(base + kBodyStride * bodies[i], lanes + 4 * i, 4 * sizeof(float32));
        }
    }
}

} // namespace
} // namespace box2d
