// SPDX-License-Identifier: MIT
#pragma once

#include "../JointLanes.h"

/// The solver of b2DistanceJoint, whose source has the formulas.
namespace box2d
{
namespace
{

template <class F>
struct DistanceLanes
{
    static constexpr int kImpulses = 1;
    static constexpr int kPlainImpulses = kImpulses;
    static constexpr bool kHoldsPositions = true;
    enum Features : uint8
    {
        kSpring = 1 ///< for which the positions are not held
    };

    F impulse; ///< along the axis [N s]
    Vector<F> axis;
    Vector<F> armA, armB; ///< at the start of the step [m]
    Vector<F> offset;     ///< from centre of mass A to B [m]
    F mass;               ///< effective, along the axis
    F bias, gamma;        ///< of a spring
    F length;             ///< that it shall have [m]
    F isSpring;           ///< 1 or 0

    void WarmStart(MovingPair<F>& pair, uint8) const { pair.Apply(impulse * axis, armA, armB); }

    void SolveVelocity(MovingPair<F>& pair, uint8)
    {
        const F speed = Dot(axis, pair.PointSpeed(armA, armB));
        const F change = -mass * (speed + bias + gamma * impulse);
        impulse = impulse + change;
        pair.Apply(change * axis, armA, armB);
    }

    auto SolvePosition(PlacedPair<F>& pair, uint8 features) const
    {
        const F zero = F::Set(0.0f);
        const Vector<F> turnedA = pair.a.Turn(armA);
        const Vector<F> turnedB = pair.b.Turn(armB);
        Vector<F> along = pair.Offset(offset) + turnedB - turnedA;
        const F now = Normalize(along);
        const F most = F::Set(b2_maxLinearCorrection);
        const F error = Clamp(now - length, -most, most);
        const F k = pair.AxisMatrix(along, turnedA, turnedB);
        auto held = Not(Or(AtLeast(zero, now), AtLeast(zero, k)));
        auto joined = AtLeast(F::Set(b2_linearSlop), Abs(error));
        if ((features & kSpring) != 0)
        {
            held = And(held, Not(IsSet(isSpring)));
            joined = Or(joined, IsSet(isSpring));
        }
        PlacedPair<F> moved = pair;
        moved.Move((-error / Select(held, k, F::Set(1.0f))) * along, turnedA, turnedB);
        pair.Take(held, moved);
        return joined;
    }
};

} // namespace
} // namespace box2d
