// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#define BOX2D_SSE2 1
#include <immintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#define BOX2D_NEON 1
#include <arm_neon.h>
#endif

#if defined(__GNUC__)
#define BOX2D_INLINE [[gnu::always_inline]] inline ///< keeps lanes in registers
#define BOX2D_NOINLINE [[gnu::noinline]]           ///< keeps rare code out of the hot path
#else
#define BOX2D_INLINE inline
#define BOX2D_NOINLINE
#endif

/// Vectors of single-precision numbers. Every operation gives in each lane exactly the scalar
/// result, so that results do not depend on the width or the processor. Intrinsics are only here
/// and in SimdWide.h. With BOX2D_PLAIN_SIMD defined, or on an unknown processor, it is plain C++.
///
/// All functions have internal linkage, so that a source compiled for AVX2 does not provide code to
/// the others.
namespace box2d::simd
{
namespace
{

#if defined(BOX2D_SSE2) && !defined(BOX2D_PLAIN_SIMD)

struct Float4
{
    static constexpr int kLanes = 4;
    __m128 v;

    static Float4 Load(const float* from) { return {_mm_loadu_ps(from)}; }
    static Float4 Set(float value) { return {_mm_set1_ps(value)}; }
    void Store(float* to) const { _mm_storeu_ps(to, v); }
};
/// A boolean per lane: all bits set or none.
typedef Float4 Mask4;

inline Float4 operator+(Float4 a, Float4 b)
{
    return {_mm_add_ps(a.v, b.v)};
}
inline Float4 operator-(Float4 a, Float4 b)
{
    return {_mm_sub_ps(a.v, b.v)};
}
inline Float4 operator*(Float4 a, Float4 b)
{
    return {_mm_mul_ps(a.v, b.v)};
}
inline Float4 operator/(Float4 a, Float4 b)
{
    return {_mm_div_ps(a.v, b.v)};
}
inline Float4 operator-(Float4 a)
{
    return {_mm_xor_ps(a.v, _mm_set1_ps(-0.0f))};
}
inline Float4 Min(Float4 a, Float4 b)
{
    return {_mm_min_ps(a.v, b.v)};
} ///< a < b ? a : b
inline Float4 Max(Float4 a, Float4 b)
{
    return {_mm_max_ps(a.v, b.v)};
} ///< a > b ? a : b
inline Mask4 AtLeast(Float4 a, Float4 b)
{
    return {_mm_cmpge_ps(a.v, b.v)};
}
inline Float4 Sqrt(Float4 a)
{
    return {_mm_sqrt_ps(a.v)};
}
inline bool Any(Mask4 a)
{
    return _mm_movemask_ps(a.v) != 0;
}
inline Mask4 Not(Mask4 a)
{
    return {_mm_xor_ps(a.v, _mm_castsi128_ps(_mm_set1_epi32(-1)))};
}
inline Mask4 Or(Mask4 a, Mask4 b)
{
    return {_mm_or_ps(a.v, b.v)};
}
inline Mask4 And(Mask4 a, Mask4 b)
{
    return {_mm_and_ps(a.v, b.v)};
}
inline Float4 Select(Mask4 which, Float4 yes, Float4 no)
{
    return {_mm_or_ps(_mm_and_ps(which.v, yes.v), _mm_andnot_ps(which.v, no.v))};
}

/// Loads four consecutive pairs into vectors of first and second numbers.
inline void LoadPairs(const float* from, Float4& first, Float4& second)
{
    const __m128 a = _mm_loadu_ps(from);
    const __m128 b = _mm_loadu_ps(from + 4);
    first.v = _mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0));
    second.v = _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1));
}

/// Transposes four rows of four numbers, and back.
BOX2D_INLINE void LoadRows(const float* base, int stride, const std::int32_t* rows,
                           Float4 (&columns)[4])
{
    __m128 a = _mm_loadu_ps(base + stride * rows[0]);
    __m128 b = _mm_loadu_ps(base + stride * rows[1]);
    __m128 c = _mm_loadu_ps(base + stride * rows[2]);
    __m128 d = _mm_loadu_ps(base + stride * rows[3]);
    _MM_TRANSPOSE4_PS(a, b, c, d);
    columns[0].v = a;
    columns[1].v = b;
    columns[2].v = c;
    columns[3].v = d;
}
BOX2D_INLINE void StoreRows(float* base, int stride, const std::int32_t* rows,
                            const Float4 (&columns)[4])
{
    __m128 a = columns[0].v;
    __m128 b = columns[1].v;
    __m128 c = columns[2].v;
    __m128 d = columns[3].v;
    _MM_TRANSPOSE4_PS(a, b, c, d);
    _mm_storeu_ps(base + stride * rows[0], a);
    _mm_storeu_ps(base + stride * rows[1], b);
    _mm_storeu_ps(base + stride * rows[2], c);
    _mm_storeu_ps(base + stride * rows[3], d);
}

#elif defined(BOX2D_NEON) && !defined(BOX2D_PLAIN_SIMD)

struct Float4
{
    static constexpr int kLanes = 4;
    float32x4_t v;

    static Float4 Load(const float* from) { return {vld1q_f32(from)}; }
    static Float4 Set(float value) { return {vdupq_n_f32(value)}; }
    void Store(float* to) const { vst1q_f32(to, v); }
};
struct Mask4
{
    uint32x4_t v;
};

inline Float4 operator+(Float4 a, Float4 b)
{
    return {vaddq_f32(a.v, b.v)};
}
inline Float4 operator-(Float4 a, Float4 b)
{
    return {vsubq_f32(a.v, b.v)};
}
inline Float4 operator*(Float4 a, Float4 b)
{
    return {vmulq_f32(a.v, b.v)};
}
inline Float4 operator/(Float4 a, Float4 b)
{
    return {vdivq_f32(a.v, b.v)};
}
inline Float4 operator-(Float4 a)
{
    return {vnegq_f32(a.v)};
}
inline Mask4 AtLeast(Float4 a, Float4 b)
{
    return {vcgeq_f32(a.v, b.v)};
}
inline Float4 Sqrt(Float4 a)
{
    return {vsqrtq_f32(a.v)};
}
inline bool Any(Mask4 a)
{
    return vmaxvq_u32(a.v) != 0;
}
inline Mask4 Not(Mask4 a)
{
    return {vmvnq_u32(a.v)};
}
inline Mask4 Or(Mask4 a, Mask4 b)
{
    return {vorrq_u32(a.v, b.v)};
}
inline Mask4 And(Mask4 a, Mask4 b)
{
    return {vandq_u32(a.v, b.v)};
}
inline Float4 Select(Mask4 which, Float4 yes, Float4 no)
{
    return {vbslq_f32(which.v, yes.v, no.v)};
}
// By comparison, because the min and max instructions treat zeros and NaN differently.
inline Float4 Min(Float4 a, Float4 b)
{
    return Select(Mask4{vcltq_f32(a.v, b.v)}, a, b);
}
inline Float4 Max(Float4 a, Float4 b)
{
    return Select(Mask4{vcgtq_f32(a.v, b.v)}, a, b);
}

inline void LoadPairs(const float* from, Float4& first, Float4& second)
{
    const float32x4x2_t pairs = vld2q_f32(from);
    first.v = pairs.val[0];
    second.v = pairs.val[1];
}
inline void Transpose(Float4 (&m)[4])
{
    const float32x4x2_t ab = vtrnq_f32(m[0].v, m[1].v);
    const float32x4x2_t cd = vtrnq_f32(m[2].v, m[3].v);
    m[0].v = vcombine_f32(vget_low_f32(ab.val[0]), vget_low_f32(cd.val[0]));
    m[1].v = vcombine_f32(vget_low_f32(ab.val[1]), vget_low_f32(cd.val[1]));
    m[2].v = vcombine_f32(vget_high_f32(ab.val[0]), vget_high_f32(cd.val[0]));
    m[3].v = vcombine_f32(vget_high_f32(ab.val[1]), vget_high_f32(cd.val[1]));
}
BOX2D_INLINE void LoadRows(const float* base, int stride, const std::int32_t* rows,
                           Float4 (&columns)[4])
{
    for (int i = 0; i < 4; ++i)
    {
        columns[i] = Float4::Load(base + stride * rows[i]);
    }
    Transpose(columns);
}
BOX2D_INLINE void StoreRows(float* base, int stride, const std::int32_t* rows,
                            const Float4 (&columns)[4])
{
    Float4 m[4] = {columns[0], columns[1], columns[2], columns[3]};
    Transpose(m);
    for (int i = 0; i < 4; ++i)
    {
        m[i].Store(base + stride * rows[i]);
    }
}

#else

struct Float4
{
    static constexpr int kLanes = 4;
    float v[4];

    static Float4 Load(const float* from) { return {{from[0], from[1], from[2], from[3]}}; }
    static Float4 Set(float value) { return {{value, value, value, value}}; }
    void Store(float* to) const
    {
        for (int i = 0; i < 4; ++i)
        {
            to[i] = v[i];
        }
    }
};
struct Mask4
{
    bool v[4];
};

template <class Function>
inline Float4 EachLane(Function function)
{
    return {{function(0), function(1), function(2), function(3)}};
}
inline Float4 operator+(Float4 a, Float4 b)
{
    return EachLane([&](int i) { return a.v[i] + b.v[i]; });
}
inline Float4 operator-(Float4 a, Float4 b)
{
    return EachLane([&](int i) { return a.v[i] - b.v[i]; });
}
inline Float4 operator*(Float4 a, Float4 b)
{
    return EachLane([&](int i) { return a.v[i] * b.v[i]; });
}
inline Float4 operator/(Float4 a, Float4 b)
{
    return EachLane([&](int i) { return a.v[i] / b.v[i]; });
}
inline Float4 operator-(Float4 a)
{
    return EachLane([&](int i) { return -a.v[i]; });
}
inline Float4 Min(Float4 a, Float4 b)
{
    return EachLane([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
inline Float4 Max(Float4 a, Float4 b)
{
    return EachLane([&](int i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
}
inline Mask4 AtLeast(Float4 a, Float4 b)
{
    return {{a.v[0] >= b.v[0], a.v[1] >= b.v[1], a.v[2] >= b.v[2], a.v[3] >= b.v[3]}};
}
inline Float4 Sqrt(Float4 a)
{
    return EachLane([&](int i) { return std::sqrt(a.v[i]); });
}
inline bool Any(Mask4 a)
{
    return a.v[0] || a.v[1] || a.v[2] || a.v[3];
}
inline Mask4 Not(Mask4 a)
{
    return {{!a.v[0], !a.v[1], !a.v[2], !a.v[3]}};
}
inline Mask4 Or(Mask4 a, Mask4 b)
{
    return {{a.v[0] || b.v[0], a.v[1] || b.v[1], a.v[2] || b.v[2], a.v[3] || b.v[3]}};
}
inline Mask4 And(Mask4 a, Mask4 b)
{
    return {{a.v[0] && b.v[0], a.v[1] && b.v[1], a.v[2] && b.v[2], a.v[3] && b.v[3]}};
}
inline Float4 Select(Mask4 which, Float4 yes, Float4 no)
{
    return EachLane([&](int i) { return which.v[i] ? yes.v[i] : no.v[i]; });
}
inline void LoadPairs(const float* from, Float4& first, Float4& second)
{
    first = EachLane([&](int i) { return from[2 * i]; });
    second = EachLane([&](int i) { return from[2 * i + 1]; });
}
BOX2D_INLINE void LoadRows(const float* base, int stride, const std::int32_t* rows,
                           Float4 (&columns)[4])
{
    for (int i = 0; i < 4; ++i)
    {
        columns[i] = EachLane([&](int row) { return base[stride * rows[row] + i]; });
    }
}
BOX2D_INLINE void StoreRows(float* base, int stride, const std::int32_t* rows,
                            const Float4 (&columns)[4])
{
    for (int row = 0; row < 4; ++row)
    {
        for (int i = 0; i < 4; ++i)
        {
            base[stride * rows[row] + i] = columns[i].v[row];
        }
    }
}

#endif

/// A single number with the same interface, so that the same source solves remaining constraints.
struct Float1
{
    static constexpr int kLanes = 1;
    float v;

    static Float1 Load(const float* from) { return {*from}; }
    static Float1 Set(float value) { return {value}; }
    void Store(float* to) const { *to = v; }
};
struct Mask1
{
    bool v;
};

inline Float1 operator+(Float1 a, Float1 b)
{
    return {a.v + b.v};
}
inline Float1 operator-(Float1 a, Float1 b)
{
    return {a.v - b.v};
}
inline Float1 operator*(Float1 a, Float1 b)
{
    return {a.v * b.v};
}
inline Float1 operator/(Float1 a, Float1 b)
{
    return {a.v / b.v};
}
inline Float1 operator-(Float1 a)
{
    return {-a.v};
}
inline Float1 Min(Float1 a, Float1 b)
{
    return {a.v < b.v ? a.v : b.v};
}
inline Float1 Max(Float1 a, Float1 b)
{
    return {a.v > b.v ? a.v : b.v};
}
inline Mask1 AtLeast(Float1 a, Float1 b)
{
    return {a.v >= b.v};
}
inline Float1 Sqrt(Float1 a)
{
    return {std::sqrt(a.v)};
}
inline bool Any(Mask1 a)
{
    return a.v;
}
inline Mask1 Not(Mask1 a)
{
    return {!a.v};
}
inline Mask1 Or(Mask1 a, Mask1 b)
{
    return {a.v || b.v};
}
inline Mask1 And(Mask1 a, Mask1 b)
{
    return {a.v && b.v};
}
inline Float1 Select(Mask1 which, Float1 yes, Float1 no)
{
    return which.v ? yes : no;
}
BOX2D_INLINE void LoadRows(const float* base, int stride, const std::int32_t* rows,
                           Float1 (&columns)[4])
{
    for (int i = 0; i < 4; ++i)
    {
        columns[i].v = base[stride * rows[0] + i];
    }
}
BOX2D_INLINE void StoreRows(float* base, int stride, const std::int32_t* rows,
                            const Float1 (&columns)[4])
{
    for (int i = 0; i < 4; ++i)
    {
        base[stride * rows[0] + i] = columns[i].v;
    }
}

} // namespace
} // namespace box2d::simd

#include "SimdWide.h"
