// SPDX-License-Identifier: MIT
#include "ContactBlocks.h"

#include "ContactBlockSolver.h"

#include <cstring>

namespace box2d
{

#if defined(BOX2D_AVX2)
// ContactBlocksAvx2.cpp
void WarmStartBlockAvx2(ContactBlock& block, float32* bodies);
void SolveBlockAvx2(ContactBlock& block, float32* bodies);
#endif

namespace
{

BlockKind KindOf(const ContactConstraint& c)
{
    return c.pointCount == 1 ? BlockKind::One : c.coupled ? BlockKind::Pair : BlockKind::Two;
}

ContactBlock& AddBlock(BlockKind kind, Array<ContactBlock>& blocks)
{
    ContactBlock& block = blocks.emplace_back();
    std::memset(&block, 0, sizeof block);
    block.kind = kind;
    for (int lane = 0; lane < kBlockLanes; ++lane)
    {
        block.k11[lane] = 1.0f; // something to divide by
        block.k22[lane] = 1.0f;
    }
    return block;
}

void FillPoint(const ContactPoint& from, PointLanes& to, int lane)
{
    to.armAX[lane] = from.armA.x;
    to.armAY[lane] = from.armA.y;
    to.armBX[lane] = from.armB.x;
    to.armBY[lane] = from.armB.y;
    to.normalImpulse[lane] = from.normalImpulse;
    to.tangentImpulse[lane] = from.tangentImpulse;
    to.normalMass[lane] = from.normalMass;
    to.tangentMass[lane] = from.tangentMass;
    to.bias[lane] = from.bias;
}

void FillLane(const ContactConstraint& c, int32 index, ContactBlock& block)
{
    const int lane = block.count++;
    block.constraint[lane] = index;
    block.bodyA[lane] = c.bodyA;
    block.bodyB[lane] = c.bodyB;
    block.normalX[lane] = c.normal.x;
    block.normalY[lane] = c.normal.y;
    block.friction[lane] = c.friction;
    block.tangentSpeed[lane] = c.tangentSpeed;
    block.invMassA[lane] = c.invMassA;
    block.invInertiaA[lane] = c.invInertiaA;
    block.invMassB[lane] = c.invMassB;
    block.invInertiaB[lane] = c.invInertiaB;
    for (int32 i = 0; i < c.pointCount; ++i)
    {
        FillPoint(c.points[i], block.points[i], lane);
    }
    if (c.coupled)
    {
        block.k11[lane] = c.k11;
        block.k12[lane] = c.k12;
        block.k22[lane] = c.k22;
    }
}

bool DetectWideInstructions()
{
#if defined(BOX2D_AVX2)
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

bool s_wide = DetectWideInstructions();

float32* Numbers(SolverBody* bodies)
{
    return reinterpret_cast<float32*>(bodies);
}

} // namespace

bool HasWideInstructions()
{
    return DetectWideInstructions();
}

void UseWideInstructions(bool use)
{
    s_wide = use && DetectWideInstructions();
}

void PackBlocks(const Array<ContactConstraint>& constraints, std::size_t begin, std::size_t end,
                bool mayShareBodies, Array<ContactBlock>& blocks)
{
    int32 open[kBlockKinds] = {-1, -1, -1};
    for (std::size_t i = begin; i < end; ++i)
    {
        const ContactConstraint& c = constraints[i];
        const BlockKind kind = KindOf(c);
        int32& last = open[int(kind)];
        if (last == -1 || mayShareBodies || blocks[std::size_t(last)].count == kBlockLanes)
        {
            last = int32(blocks.size());
            AddBlock(kind, blocks);
        }
        FillLane(c, int32(i), blocks[std::size_t(last)]);
    }
}

void UnpackImpulses(const Array<ContactBlock>& blocks, Array<ContactConstraint>& constraints)
{
    for (const ContactBlock& block : blocks)
    {
        for (int lane = 0; lane < block.count; ++lane)
        {
            ContactConstraint& c = constraints[std::size_t(block.constraint[lane])];
            for (int32 i = 0; i < c.pointCount; ++i)
            {
                c.points[i].normalImpulse = block.points[i].normalImpulse[lane];
                c.points[i].tangentImpulse = block.points[i].tangentImpulse[lane];
            }
        }
    }
}

void WarmStartBlocks(Array<ContactBlock>& blocks, SolverBody* bodies)
{
#if defined(BOX2D_AVX2)
    if (s_wide)
    {
        for (ContactBlock& block : blocks)
        {
            WarmStartBlockAvx2(block, Numbers(bodies));
        }
        return;
    }
#endif
    for (ContactBlock& block : blocks)
    {
        WarmStartBlock<simd::Float4>(block, Numbers(bodies));
    }
}

void SolveBlocks(Array<ContactBlock>& blocks, SolverBody* bodies, Direction direction)
{
#if defined(BOX2D_AVX2)
    if (s_wide)
    {
        ForEach(blocks, direction,
                [bodies](ContactBlock& b) { SolveBlockAvx2(b, Numbers(bodies)); });
        return;
    }
#endif
    ForEach(blocks, direction,
            [bodies](ContactBlock& b) { SolveBlock<simd::Float4>(b, Numbers(bodies)); });
}

} // namespace box2d
