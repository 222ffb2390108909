// SPDX-License-Identifier: MIT
// Compiled for AVX2, like JointBlocksAvx2.cpp; called if the processor supports it. It must not
// call inline functions that other sources use too: the linker keeps one copy of each, possibly
// this one.
#include "ContactBlockPrepare.h"
#include "OverlapBlockSolver.h"
#include "OverlapSolver.h"

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

void KickBlockAvx2(ContactBlock& block, BlockTotals& totals, float32* bodies, float32 share,
                   bool addsLast)
{
    KickBlock<simd::Float8>(block, totals, bodies, share, addsLast);
}

void AddToTotalsAvx2(const ContactBlock& block, BlockTotals& totals)
{
    AddToTotals<simd::Float8>(block, totals);
}

void FindErrorsAvx2(const ContactBlock& block, const float32* bodies, float32 sticks, float32* off)
{
    FindErrors<simd::Float8>(block, bodies, sticks, off);
}

bool SolveBlockAvx2(ContactBlock& block, float32* bodies)
{
    return SolveBlock<simd::Float8>(block, bodies);
}

float32 SolveOverlapBlockAvx2(const OverlapBlock& block, const MassLanes& masses, float32* bodies,
                              PushPace pace)
{
    return SolveOverlapBlock<simd::Float8>(block, masses, bodies, pace);
}

} // namespace box2d
