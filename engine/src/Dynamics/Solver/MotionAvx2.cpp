// SPDX-License-Identifier: MIT
// Compiled for AVX2, see ContactBlocksAvx2.cpp.
#include "MotionLanes.h"

namespace box2d
{

const MotionKernels& MotionKernelsAvx2()
{
    return kMotionKernels<simd::Float8>;
}

} // namespace box2d
