// SPDX-License-Identifier: MIT
#include "WideInstructions.h"

#include <algorithm>

namespace box2d
{

int g_lanes = WidestLanes();

int WidestLanes()
{
#if defined(BOX2D_AVX512)
    if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0)
    {
        return 16;
    }
#endif
#if defined(BOX2D_AVX2)
    if (__builtin_cpu_supports("avx2") != 0)
    {
        return 8;
    }
#endif
    return 4;
}

void UseLanes(int most)
{
    g_lanes = std::min(most, WidestLanes());
}

} // namespace box2d
