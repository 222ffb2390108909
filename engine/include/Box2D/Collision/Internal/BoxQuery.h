// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

/// Internal to the engine.
namespace box2d
{

/// One box that is tested against many: true as b2TestOverlap is, with its four comparisons at once
/// where the processor can.
class BoxQuery
{
public:
#if defined(__SSE2__)
    // lower <= upper of the query, and -upper <= -lower of the query
    explicit BoxQuery(const b2AABB& box)
        : m_bounds(
              _mm_setr_ps(box.upperBound.x, box.upperBound.y, -box.lowerBound.x, -box.lowerBound.y))
    {}

    bool Overlaps(const b2AABB& box) const
    {
        static_assert(sizeof(b2AABB) == sizeof(__m128));
        const __m128 minus = _mm_setr_ps(0.0f, 0.0f, -0.0f, -0.0f);
        const __m128 bounds = _mm_xor_ps(_mm_loadu_ps(&box.lowerBound.x), minus);
        return _mm_movemask_ps(_mm_cmple_ps(bounds, m_bounds)) == 0xF;
    }

private:
    __m128 m_bounds;
#else
    explicit BoxQuery(const b2AABB& box) : m_box(box) {}
    bool Overlaps(const b2AABB& box) const
    {
        return b2TestOverlap(m_box, box);
    }

private:
    b2AABB m_box;
#endif
};

} // namespace box2d
