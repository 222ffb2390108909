// SPDX-License-Identifier: MIT
// Compiled for AVX2 and called where the processor has it; see ContactBlocksAvx2.cpp.
#include "HingeBlockSolver.h"

namespace box2d
{

void PrepareHingeMatrixAvx2(HingeBlock& block)
{
    PrepareHingeMatrix<simd::Float8>(block);
}

void WarmStartHingeBlockAvx2(HingeBlock& block, float32* bodies)
{
    WarmStartHingeBlock<simd::Float8>(block, bodies);
}

void SolveHingeBlockVelocitiesAvx2(HingeBlock& block, float32* bodies)
{
    SolveHingeBlockVelocities<simd::Float8>(block, bodies);
}

bool SolveHingeBlockPositionsAvx2(const HingeBlock& block, float32* bodies)
{
    return SolveHingeBlockPositions<simd::Float8>(block, bodies);
}

} // namespace box2d
