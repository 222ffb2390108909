// SPDX-License-Identifier: MIT
#include "WideInstructions.h"

namespace box2d
{

bool g_usesWideInstructions = HasWideInstructions();

bool HasWideInstructions()
{
#if defined(BOX2D_AVX2)
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

void UseWideInstructions(bool use)
{
    g_usesWideInstructions = use && HasWideInstructions();
}

} // namespace box2d
