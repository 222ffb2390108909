// SPDX-License-Identifier: MIT
// Compiled for AVX2, like JointBlocksAvx2.cpp; used if the processor supports it. It must not
// call inline functions that other sources use too: the linker keeps one copy of each, possibly
// this one.
#include "BlockKernels.h"

namespace box2d
{

const BlockKernels& BlockKernelsAvx2()
{
    return kBlockKernels<simd::Float8>;
}

} // namespace box2d
