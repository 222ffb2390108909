// SPDX-License-Identifier: MIT
#pragma once

#include "ContactBlockPrepare.h"
#include "OverlapBlockSolver.h"

/// The functions for blocks of contacts at one number of lanes.
namespace box2d
{

struct BlockKernels
{
    void (*prepare)(const ContactLanes& from, ContactBlock& block, OverlapBlock& overlap,
                    const SolverContext& context);
    void (*warmStart)(ContactBlock& block, float32* bodies);
    void (*kick)(ContactBlock& block, BlockTotals& totals, float32* bodies, float32 share,
                 bool addsLast);
    void (*addToTotals)(const ContactBlock& block, BlockTotals& totals);
    void (*limitFriction)(ContactBlock& block, float32* bodies);
    void (*findErrors)(const ContactBlock& block, const float32* bodies, const ErrorBounds& bounds,
                       float32* off);
    bool (*solve)(ContactBlock& block, float32* bodies, float32 unchanged);
    float32 (*solveOverlaps)(const OverlapBlock& block, const MassLanes& masses, float32* bodies,
                             PushPace pace);
};

namespace
{

template <class F>
constexpr BlockKernels kBlockKernels = {PrepareBlock<F>, WarmStartBlock<F>,   KickBlock<F>,
                                        AddToTotals<F>,  LimitFriction<F>,    FindErrors<F>,
                                        SolveBlock<F>,   SolveOverlapBlock<F>};

} // namespace
} // namespace box2d
