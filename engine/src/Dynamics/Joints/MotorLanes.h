// SPDX-License-Identifier: MIT
#pragma once

#include "FrictionLanes.h"

class b2MotorJoint;

/// The solver of b2MotorJoint, whose source has the formulas: friction towards a place.
namespace box2d
{
namespace
{

template <class F>
struct MotorLanes
{
    static constexpr int kImpulses = FrictionLanes<F>::kImpulses;
    static constexpr int kPlainImpulses = kImpulses;

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

template <class F>
struct LanesOf<b2MotorJoint, F> : std::type_identity<MotorLanes<F>>
{};

} // namespace
} // namespace box2d
