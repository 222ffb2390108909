// SPDX-License-Identifier: MIT
#pragma once

#include "Solver.h"

class b2RevoluteJoint;

/// Revolute joints that share no moving body, eight at a time: what b2RevoluteJoint.cpp does to
/// one, by 8, by twice 4 or by 8 times one lane with the same bits. The joint's own functions stay
/// as the reference, and solve what is alone.
namespace box2d
{

inline constexpr int kHingeLanes = 8;

/// Lanes that are not used belong to bodies 0 without mass.
struct HingeBlock
{
    int32 bodyA[kHingeLanes], bodyB[kHingeLanes];
    float32 armAX[kHingeLanes], armAY[kHingeLanes]; ///< at the start of the step [m]
    float32 armBX[kHingeLanes], armBY[kHingeLanes];
    float32 offsetX[kHingeLanes], offsetY[kHingeLanes]; ///< from centre of mass A to B [m]
    float32 invMassA[kHingeLanes], invInertiaA[kHingeLanes];
    float32 invMassB[kHingeLanes], invInertiaB[kHingeLanes];
    float32 impulseX[kHingeLanes], impulseY[kHingeLanes];
    // The effective mass of the point: matrix and one over its determinant.
    float32 k11[kHingeLanes], k12[kHingeLanes], k22[kHingeLanes], inverse[kHingeLanes];

    // About the hinge; not looked at where no lane has a motor or limits.
    float32 hasMotor[kHingeLanes], hasLimits[kHingeLanes]; ///< 1 or 0
    float32 axialMass[kHingeLanes];
    float32 angle[kHingeLanes]; ///< at the start of the step [rad]
    float32 lower[kHingeLanes], upper[kHingeLanes];
    float32 lowerSpeed[kHingeLanes], upperSpeed[kHingeLanes]; ///< that reach the limits in one step
    float32 motorSpeed[kHingeLanes], motorLimit[kHingeLanes]; ///< [rad/s], [N m s]
    float32 motorImpulse[kHingeLanes], lowerImpulse[kHingeLanes], upperImpulse[kHingeLanes];

    b2RevoluteJoint* joint[kHingeLanes];
    int32 count = 0;      ///< used lanes
    bool axial;           ///< some lane has a motor or limits
    uint8 movesA, movesB; ///< a bit for each lane whose body can be pushed or turned
};

// For the widest instructions that this processor has; see UseWideInstructions.

/// Reads joints and bodies.
void PrepareHinges(HingeBlock& block, const SolverContext& context);
void WarmStartHinges(HingeBlock& block, SolverBody* bodies);
void SolveHingeVelocities(HingeBlock& block, SolverBody* bodies);
void StoreHingeImpulses(const HingeBlock& block);
/// Whether all errors were below the tolerance.
bool SolveHingePositions(const HingeBlock& block, SolverBody* bodies);

} // namespace box2d
