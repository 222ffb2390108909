// SPDX-License-Identifier: MIT
// Compiled for AVX2, like JointBlocksAvx2.cpp; called if the processor supports it. It must not
// call inline functions that other sources use too: the linker keeps one copy of each, possibly
// this one.
#include "ContactBlockPrepare.h"
#include "OverlapBlockSolver.h"

namespace box2d
{

void PrepareBlockAvx2(const ContactLanes& from, ContactBlock& block, OverlapBlock& overlap,
                      const SolverContext& context)
{
    PrepareBlock<simd::Float8>(from, block, overlap, context);
}

void WarmStartBlockAvx2(ContactBlock& block, float32* bodies)
{
    WarmStartBlock<simd::Float8>(block, bodies);
}

bool SolveBlockAvx2(ContactBlock& block, float32* bodies)
{
    return SolveBlock<simd::Float8>(block, bodies);
}

float32 SolveOverlapBlockAvx2(const OverlapBlock& block, float32* bodies, PushPace pace)
{
    return SolveOverlapBlock<simd::Float8>(block, bodies, pace);
}

} // namespace box2d
