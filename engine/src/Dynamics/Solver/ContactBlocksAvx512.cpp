// SPDX-License-Identifier: MIT
// Compiled for AVX-512; see ContactBlocksAvx2.cpp.
#include "BlockKernels.h"

namespace box2d
{

const BlockKernels& BlockKernelsAvx512()
{
    return kBlockKernels<simd::Float16>;
}

} // namespace box2d
