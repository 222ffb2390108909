// SPDX-License-Identifier: MIT
#pragma once

#include "FrictionLanes.h"

/// The solver of b2MotorJoint; its source file contains the formulas: friction towards a target.
namespace box2d
{
namespace
{

template <class F>
struct MotorLanes
{
    static constexpr int kImpulses = FrictionLanes<F>::kImpulses;
    static constexpr int kPlainImpulses = kImpulses;
    static constexpr bool kHoldsPositions = false;

    FrictionLanes<F> friction;
    Vector<F> bias; ///< correction speed of the position [m/s]
    F angularBias;  ///< [rad/s]

    void WarmStart(MovingPair<F>& pair, uint8 features) const
    {
        friction.WarmStart(pair, features);
    }
    void SolveVelocity(MovingPair<F>& pair, uint8)
    {
        friction.SolveAngular(pair, pair.wB - pair.wA + angularBias);
        friction.SolveLinear(pair, pair.PointSpeed(friction.armA, friction.armB) + bias);
    }
};

} // namespace
} // namespace box2d
