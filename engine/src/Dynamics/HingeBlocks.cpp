// SPDX-License-Identifier: MIT
#include "HingeBlocks.h"

#include "ContactBlocks.h"
#include "HingeBlockSolver.h"

#include "Joints/JointFrame.h"

#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>

namespace box2d
{

#if defined(BOX2D_AVX2)
// HingeBlocksAvx2.cpp
void PrepareHingeMatrixAvx2(HingeBlock& block);
void WarmStartHingeBlockAvx2(HingeBlock& block, float32* bodies);
void SolveHingeBlockVelocitiesAvx2(HingeBlock& block, float32* bodies);
bool SolveHingeBlockPositionsAvx2(const HingeBlock& block, float32* bodies);
#endif

namespace
{

float32* Numbers(SolverBody* bodies)
{
    return reinterpret_cast<float32*>(bodies);
}

} // namespace

/// The way to what a hinge keeps private.
struct HingeAccess
{
    static void Gather(HingeBlock& block, int lane, const SolverContext& context);
    static void GatherAxis(HingeBlock& block, int lane, const SolverContext& context);
    static void Store(const HingeBlock& block, int lane);
};

void HingeAccess::Gather(HingeBlock& block, int lane, const SolverContext& context)
{
    b2RevoluteJoint& joint = *block.joint[lane];
    const JointFrame f(*joint.GetBodyA(), *joint.GetBodyB(), context);
    joint.Ready(f, context);
    block.bodyA[lane] = f.dataA.SolverIndex();
    block.bodyB[lane] = f.dataB.SolverIndex();
    block.armAX[lane] = joint.m_armA.x;
    block.armAY[lane] = joint.m_armA.y;
    block.armBX[lane] = joint.m_armB.x;
    block.armBY[lane] = joint.m_armB.y;
    block.offsetX[lane] = joint.m_offset.x;
    block.offsetY[lane] = joint.m_offset.y;
    block.invMassA[lane] = f.mA;
    block.invInertiaA[lane] = f.iA;
    block.invMassB[lane] = f.mB;
    block.invInertiaB[lane] = f.iB;
    block.impulseX[lane] = joint.m_impulse.x;
    block.impulseY[lane] = joint.m_impulse.y;
    block.movesA = uint8(block.movesA | int(Moves(f.mA, f.iA)) << lane);
    block.movesB = uint8(block.movesB | int(Moves(f.mB, f.iB)) << lane);
    block.axial = block.axial || joint.m_enableMotor || joint.m_enableLimit;
}

void HingeAccess::GatherAxis(HingeBlock& block, int lane, const SolverContext& context)
{
    const b2RevoluteJoint& joint = *block.joint[lane];
    block.hasMotor[lane] = joint.m_enableMotor ? 1.0f : 0.0f;
    block.hasLimits[lane] = joint.m_enableLimit ? 1.0f : 0.0f;
    block.axialMass[lane] = joint.m_axialMass;
    block.angle[lane] = joint.m_angle;
    block.lower[lane] = joint.m_lowerAngle;
    block.upper[lane] = joint.m_upperAngle;
    block.lowerSpeed[lane] = joint.SpeedToLower(context);
    block.upperSpeed[lane] = joint.SpeedToUpper(context);
    block.motorSpeed[lane] = joint.m_motorSpeed;
    block.motorLimit[lane] = context.timeStep * joint.m_maxMotorTorque;
    block.motorImpulse[lane] = joint.m_motorImpulse;
    block.lowerImpulse[lane] = joint.m_lowerImpulse;
    block.upperImpulse[lane] = joint.m_upperImpulse;
}

void HingeAccess::Store(const HingeBlock& block, int lane)
{
    b2RevoluteJoint& joint = *block.joint[lane];
    joint.m_impulse.Set(block.impulseX[lane], block.impulseY[lane]);
    if (block.axial)
    {
        joint.m_motorImpulse = block.motorImpulse[lane];
        joint.m_lowerImpulse = block.lowerImpulse[lane];
        joint.m_upperImpulse = block.upperImpulse[lane];
    }
}

void PrepareHinges(HingeBlock& block, const SolverContext& context)
{
    block.movesA = block.movesB = 0;
    block.axial = false;
    for (int lane = 0; lane < block.count; ++lane)
    {
        HingeAccess::Gather(block, lane, context);
    }
    for (int lane = 0; lane < block.count && block.axial; ++lane)
    {
        HingeAccess::GatherAxis(block, lane, context);
    }
#if defined(BOX2D_AVX2)
    if (UsesWideInstructions())
    {
        return PrepareHingeMatrixAvx2(block);
    }
#endif
    PrepareHingeMatrix<simd::Float4>(block);
}

void WarmStartHinges(HingeBlock& block, SolverBody* bodies)
{
#if defined(BOX2D_AVX2)
    if (UsesWideInstructions())
    {
        return WarmStartHingeBlockAvx2(block, Numbers(bodies));
    }
#endif
    WarmStartHingeBlock<simd::Float4>(block, Numbers(bodies));
}

void SolveHingeVelocities(HingeBlock& block, SolverBody* bodies)
{
#if defined(BOX2D_AVX2)
    if (UsesWideInstructions())
    {
        return SolveHingeBlockVelocitiesAvx2(block, Numbers(bodies));
    }
#endif
    SolveHingeBlockVelocities<simd::Float4>(block, Numbers(bodies));
}

void StoreHingeImpulses(const HingeBlock& block)
{
    for (int lane = 0; lane < block.count; ++lane)
    {
        HingeAccess::Store(block, lane);
    }
}

bool SolveHingePositions(const HingeBlock& block, SolverBody* bodies)
{
#if defined(BOX2D_AVX2)
    if (UsesWideInstructions())
    {
        return SolveHingeBlockPositionsAvx2(block, Numbers(bodies));
    }
#endif
    return SolveHingeBlockPositions<simd::Float4>(block, Numbers(bodies));
}

} // namespace box2d
