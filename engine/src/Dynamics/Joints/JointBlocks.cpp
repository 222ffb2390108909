// SPDX-License-Identifier: MIT
#include "JointBlocks.h"

#include "../../Common/WideInstructions.h"
#include "JointKernels.h"

namespace box2d
{

#if defined(BOX2D_AVX2)
const JointKernels& JointKernelsAvx2(b2JointType type); // JointBlocksAvx2.cpp
#endif

const JointKernels& KernelsOf(const JointBlock& block)
{
    if (block.width == 1)
    {
        return KernelsOf<simd::Float1>(block.type);
    }
#if defined(BOX2D_AVX2)
    if (LanesInUse() >= 8)
    {
        return JointKernelsAvx2(block.type);
    }
#endif
    return KernelsOf<simd::Float4>(block.type);
}

} // namespace box2d
