// SPDX-License-Identifier: MIT
#pragma once

/// Vectors of 8 and 16 numbers for sources compiled for AVX2 and AVX-512; part of Simd.h.
namespace box2d::simd
{
namespace
{

#if defined(__AVX2__) && !defined(BOX2D_PLAIN_SIMD)

struct Float8
{
    static constexpr int kLanes = 8;
    __m256 v;

    static Float8 Load(const float* from) { return {_mm256_loadu_ps(from)}; }
    static Float8 Set(float value) { return {_mm256_set1_ps(value)}; }
    void Store(float* to) const { _mm256_storeu_ps(to, v); }
};
typedef Float8 Mask8;

inline Float8 operator+(Float8 a, Float8 b)
{
    return {_mm256_add_ps(a.v, b.v)};
}
inline Float8 operator-(Float8 a, Float8 b)
{
    return {_mm256_sub_ps(a.v, b.v)};
}
inline Float8 operator*(Float8 a, Float8 b)
{
    return {_mm256_mul_ps(a.v, b.v)};
}
inline Float8 operator/(Float8 a, Float8 b)
{
    return {_mm256_div_ps(a.v, b.v)};
}
inline Float8 operator-(Float8 a)
{
    return {_mm256_xor_ps(a.v, _mm256_set1_ps(-0.0f))};
}
inline Float8 Min(Float8 a, Float8 b)
{
    return {_mm256_min_ps(a.v, b.v)};
}
inline Float8 Max(Float8 a, Float8 b)
{
    return {_mm256_max_ps(a.v, b.v)};
}
inline Mask8 AtLeast(Float8 a, Float8 b)
{
    return {_mm256_cmp_ps(a.v, b.v, _CMP_GE_OS)};
}
inline Float8 Sqrt(Float8 a)
{
    return {_mm256_sqrt_ps(a.v)};
}
inline bool Any(Mask8 a)
{
    return _mm256_movemask_ps(a.v) != 0;
}
inline Mask8 Not(Mask8 a)
{
    return {_mm256_xor_ps(a.v, _mm256_castsi256_ps(_mm256_set1_epi32(-1)))};
}
inline Mask8 Or(Mask8 a, Mask8 b)
{
    return {_mm256_or_ps(a.v, b.v)};
}
inline Mask8 And(Mask8 a, Mask8 b)
{
    return {_mm256_and_ps(a.v, b.v)};
}
inline Float8 Select(Mask8 which, Float8 yes, Float8 no)
{
    return {_mm256_blendv_ps(no.v, yes.v, which.v)};
}

/// Loads two rows: one into the lower half, one into the upper.
inline __m256 LoadPair(const float* lower, const float* upper)
{
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(lower)), _mm_loadu_ps(upper),
                                1);
}
/// Transposes the 4 x 4 numbers of each half.
inline void TransposeHalves(__m256& a, __m256& b, __m256& c, __m256& d)
{
    const __m256 ab0 = _mm256_unpacklo_ps(a, b);
    const __m256 ab1 = _mm256_unpackhi_ps(a, b);
    const __m256 cd0 = _mm256_unpacklo_ps(c, d);
    const __m256 cd1 = _mm256_unpackhi_ps(c, d);
    a = _mm256_shuffle_ps(ab0, cd0, _MM_SHUFFLE(1, 0, 1, 0));
    b = _mm256_shuffle_ps(ab0, cd0, _MM_SHUFFLE(3, 2, 3, 2));
    c = _mm256_shuffle_ps(ab1, cd1, _MM_SHUFFLE(1, 0, 1, 0));
    d = _mm256_shuffle_ps(ab1, cd1, _MM_SHUFFLE(3, 2, 3, 2));
}
BOX2D_INLINE void LoadRows(const float* base, int stride, const std::int32_t* rows,
                           Float8 (&columns)[4])
{
    for (int i = 0; i < 4; ++i)
    {
        columns[i].v = LoadPair(base + stride * rows[i], base + stride * rows[i + 4]);
    }
    TransposeHalves(columns[0].v, columns[1].v, columns[2].v, columns[3].v);
}
BOX2D_INLINE void StoreRows(float* base, int stride, const std::int32_t* rows,
                            const Float8 (&columns)[4])
{
    __m256 m[4] = {columns[0].v, columns[1].v, columns[2].v, columns[3].v};
    TransposeHalves(m[0], m[1], m[2], m[3]);
    for (int i = 0; i < 4; ++i)
    {
        _mm_storeu_ps(base + stride * rows[i], _mm256_castps256_ps128(m[i]));
        _mm_storeu_ps(base + stride * rows[i + 4], _mm256_extractf128_ps(m[i], 1));
    }
}

#endif

#if defined(__AVX512F__) && defined(__AVX512DQ__) && !defined(BOX2D_PLAIN_SIMD)

struct Float16
{
    static constexpr int kLanes = 16;
    __m512 v;

    static Float16 Load(const float* from) { return {_mm512_loadu_ps(from)}; }
    static Float16 Set(float value) { return {_mm512_set1_ps(value)}; }
    void Store(float* to) const { _mm512_storeu_ps(to, v); }
};
struct Mask16
{
    __mmask16 v;
};

inline Float16 operator+(Float16 a, Float16 b)
{
    return {_mm512_add_ps(a.v, b.v)};
}
inline Float16 operator-(Float16 a, Float16 b)
{
    return {_mm512_sub_ps(a.v, b.v)};
}
inline Float16 operator*(Float16 a, Float16 b)
{
    return {_mm512_mul_ps(a.v, b.v)};
}
inline Float16 operator/(Float16 a, Float16 b)
{
    return {_mm512_div_ps(a.v, b.v)};
}
inline Float16 operator-(Float16 a)
{
    return {_mm512_xor_ps(a.v, _mm512_set1_ps(-0.0f))};
}
inline Float16 Min(Float16 a, Float16 b)
{
    return {_mm512_min_ps(a.v, b.v)};
}
inline Float16 Max(Float16 a, Float16 b)
{
    return {_mm512_max_ps(a.v, b.v)};
}
inline Mask16 AtLeast(Float16 a, Float16 b)
{
    return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GE_OS)};
}
inline Float16 Sqrt(Float16 a)
{
    return {_mm512_sqrt_ps(a.v)};
}
inline bool Any(Mask16 a)
{
    return a.v != 0;
}
inline Mask16 Not(Mask16 a)
{
    return {__mmask16(~a.v)};
}
inline Mask16 Or(Mask16 a, Mask16 b)
{
    return {__mmask16(a.v | b.v)};
}
inline Mask16 And(Mask16 a, Mask16 b)
{
    return {__mmask16(a.v & b.v)};
}
inline Float16 Select(Mask16 which, Float16 yes, Float16 no)
{
    return {_mm512_mask_blend_ps(which.v, no.v, yes.v)};
}

/// Transposes the 4 x 4 numbers of each quarter.
inline void TransposeQuarters(__m512& a, __m512& b, __m512& c, __m512& d)
{
    const __m512 ab0 = _mm512_unpacklo_ps(a, b);
    const __m512 ab1 = _mm512_unpackhi_ps(a, b);
    const __m512 cd0 = _mm512_unpacklo_ps(c, d);
    const __m512 cd1 = _mm512_unpackhi_ps(c, d);
    a = _mm512_shuffle_ps(ab0, cd0, _MM_SHUFFLE(1, 0, 1, 0));
    b = _mm512_shuffle_ps(ab0, cd0, _MM_SHUFFLE(3, 2, 3, 2));
    c = _mm512_shuffle_ps(ab1, cd1, _MM_SHUFFLE(1, 0, 1, 0));
    d = _mm512_shuffle_ps(ab1, cd1, _MM_SHUFFLE(3, 2, 3, 2));
}
BOX2D_INLINE void LoadRows(const float* base, int stride, const std::int32_t* rows,
                           Float16 (&columns)[4])
{
    for (int i = 0; i < 4; ++i)
    {
        const __m256 lower = LoadPair(base + stride * rows[i], base + stride * rows[i + 4]);
        const __m256 upper = LoadPair(base + stride * rows[i + 8], base + stride * rows[i + 12]);
        columns[i].v = _mm512_insertf32x8(_mm512_castps256_ps512(lower), upper, 1);
    }
    TransposeQuarters(columns[0].v, columns[1].v, columns[2].v, columns[3].v);
}
BOX2D_INLINE void StoreRows(float* base, int stride, const std::int32_t* rows,
                            const Float16 (&columns)[4])
{
    __m512 m[4] = {columns[0].v, columns[1].v, columns[2].v, columns[3].v};
    TransposeQuarters(m[0], m[1], m[2], m[3]);
    for (int i = 0; i < 4; ++i)
    {
        _mm_storeu_ps(base + stride * rows[i], _mm512_castps512_ps128(m[i]));
        _mm_storeu_ps(base + stride * rows[i + 4], _mm512_extractf32x4_ps(m[i], 1));
        _mm_storeu_ps(base + stride * rows[i + 8], _mm512_extractf32x4_ps(m[i], 2));
        _mm_storeu_ps(base + stride * rows[i + 12], _mm512_extractf32x4_ps(m[i], 3));
    }
}

#endif

} // namespace
} // namespace box2d::simd
