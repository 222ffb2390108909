// SPDX-License-Identifier: MIT
#include "ContactBlocks.h"

#include "OverlapBlockSolver.h"

#include <cstring>

namespace box2d
{

#if defined(BOX2D_AVX2)
// ContactBlocksAvx2.cpp
void WarmStartBlockAvx2(ContactBlock& block, float32* bodies);
bool SolveBlockAvx2(ContactBlock& block, float32* bodies);
float32 SolveOverlapBlockAvx2(const OverlapBlock& block, float32* bodies, float32 rate);
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

bool SolveBlocks(Array<ContactBlock>& blocks, SolverBody* bodies, Direction direction)
{
    bool changed = false;
#if defined(BOX2D_AVX2)
    if (s_wide)
    {
        ForEach(blocks, direction, [&](ContactBlock& block) {
            changed = SolveBlockAvx2(block, Numbers(bodies)) || changed;
        });
        return changed;
    }
#endif
    ForEach(blocks, direction, [&](ContactBlock& block) {
        changed = SolveBlock<simd::Float4>(block, Numbers(bodies)) || changed;
    });
    return changed;
}

namespace
{

void FillLane(const OverlapConstraint& o, OverlapBlock& block)
{
    const int lane = block.count++;
    block.bodyA[lane] = o.bodyA;
    block.bodyB[lane] = o.bodyB;
    block.offsetX[lane] = o.offset.x;
    block.offsetY[lane] = o.offset.y;
    block.normalX[lane] = o.normal.x;
    block.normalY[lane] = o.normal.y;
    block.referenceX[lane] = o.reference.x;
    block.referenceY[lane] = o.reference.y;
    for (int32 i = 0; i < o.pointCount; ++i)
    {
        block.pointX[i][lane] = o.points[i].x;
        block.pointY[i][lane] = o.points[i].y;
    }
    block.radius[lane] = o.radius;
    block.invMassA[lane] = o.invMassA;
    block.invInertiaA[lane] = o.invInertiaA;
    block.invMassB[lane] = o.invMassB;
    block.invInertiaB[lane] = o.invInertiaB;
    block.constraint[lane] = &o;
}

OverlapBlock& AddBlock(const OverlapConstraint& like, Array<OverlapBlock>& blocks)
{
    OverlapBlock& block = blocks.emplace_back();
    std::memset(&block, 0, sizeof block);
    block.kind = like.kind;
    block.pointCount = like.pointCount;
    for (float32& radius : block.radius)
    {
        radius = -1.0f; // a metre apart
    }
    return block;
}

} // namespace

void PackBlocks(const Array<OverlapConstraint>& overlaps, std::size_t begin, std::size_t end,
                bool mayShareBodies, Array<OverlapBlock>& blocks)
{
    constexpr int kinds = 6; // three ways to measure, of one or two points
    int32 open[kinds] = {-1, -1, -1, -1, -1, -1};
    for (std::size_t i = begin; i < end; ++i)
    {
        const OverlapConstraint& o = overlaps[i];
        int32& last = open[2 * int(o.kind) + o.pointCount - 1];
        if (last == -1 || mayShareBodies || blocks[std::size_t(last)].count == kBlockLanes)
        {
            last = int32(blocks.size());
            AddBlock(o, blocks);
        }
        FillLane(o, blocks[std::size_t(last)]);
    }
}

float32 SolveBlocks(const Array<OverlapBlock>& blocks, SolverBody* bodies, float32 rate,
                    Direction direction)
{
    float32 smallest = 0.0f;
#if defined(BOX2D_AVX2)
    if (s_wide)
    {
        ForEach(blocks, direction, [&](const OverlapBlock& block) {
            smallest = b2Min(smallest, SolveOverlapBlockAvx2(block, Numbers(bodies), rate));
        });
        return smallest;
    }
#endif
    ForEach(blocks, direction, [&](const OverlapBlock& block) {
        smallest = b2Min(smallest, SolveOverlapBlock<simd::Float4>(block, Numbers(bodies), rate));
    });
    return smallest;
}

} // namespace box2d
