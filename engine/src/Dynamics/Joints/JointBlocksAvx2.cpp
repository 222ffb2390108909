// SPDX-License-Identifier: MIT
// Compiled for AVX2, used if the processor supports it; see ContactBlocksAvx2.cpp.
#include "JointKernels.h"

namespace box2d
{

const JointKernels& JointKernelsAvx2(b2JointType type)
{
    return KernelsOf<simd::Float8>(type);
}

} // namespace box2d
