// SPDX-License-Identifier: MIT
#pragma once

#include "Solver.h"

#include "../Common/Simd.h"

#include <Box2D/Common/b2Settings.h>

#include <cstring>

/// Bodies and vectors in lanes, for numbers F of 4 or 8: what all solvers on blocks build on.
/// Nothing in it has external linkage, for it is included by sources of every instruction set.
namespace box2d
{
namespace
{

/// Numbers from one body to the next.
constexpr int kBodyStride = int(sizeof(SolverBody) / sizeof(float32));

template <class F>
struct Vector
{
    F x, y;
};

template <class F>
F Cross(const Vector<F>& u, const Vector<F>& v)
{
    return u.x * v.y - u.y * v.x;
}

/// Writes the rows of the bodies that can be moved, `moves` having a bit for each lane. Others may
/// be shared by several contacts of a colour.
template <class F>
BOX2D_INLINE void StoreMoved(float32* base, const int32* bodies, uint32 moves, const F (&rows)[4])
{
    constexpr uint32 all = (1u << F::kLanes) - 1u;
    if ((moves & all) == all)
    {
        StoreRows(base, kBodyStride, bodies, rows);
        return;
    }
    static constexpr int32 order[] = {0, 1, 2, 3, 4, 5, 6, 7};
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
