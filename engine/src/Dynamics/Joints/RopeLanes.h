// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

class b2RopeJoint;

/// The solver of b2RopeJoint, whose source has the formulas.
namespace box2d
{
namespace
{

template <class F>
struct RopeLanes
{
    static constexpr int kImpulses = 1;
    static constexpr int kPlainImpulses = kImpulses;

    F impulse; ///< along the rope [N s], <= 0
    Vector<F> axis;
    Vector<F> armA, armB; ///< at the start of the step [m]
    Vector<F> offset;     ///< from centre of mass A to B [m]
    F mass;               ///< effective mass along the axis
    F slack;              ///< speed that makes it taut in this step [m/s]
    F maxLength;          ///< [m]

    void WarmStart(MovingPair<F>& pair, uint8) const { pair.Apply(impulse * axis, armA, armB); }

    void SolveVelocity(MovingPair<F>& pair, uint8)
    {
        const F speed = Dot(axis, pair.PointSpeed(armA, armB)) - slack;
        const F total = Min(impulse - mass * speed, F::Set(0.0f));
        pair.Apply((total - impulse) * axis, armA, armB);
        impulse = total;
    }

    auto SolvePosition(PlacedPair<F>& pair, uint8) const
    {
        const Vector<F> turnedA = pair.a.Turn(armA);
        const Vector<F> turnedB = pair.b.Turn(armB);
        Vector<F> along = pair.Offset(offset) + turnedB - turnedA;
        const F error = Normalize(along) - maxLength;
        const F pull = Clamp(error, F::Set(0.0f), F::Set(b2_maxLinearCorrection));
        const F k = pair.AxisMatrix(along, turnedA, turnedB);
        pair.Move((-pull * InverseOrZero(k)) * along, turnedA, turnedB);
        return AtLeast(F::Set(b2_linearSlop), error);
    }
};

template <class F>
struct LanesOf<b2RopeJoint, F> : std::type_identity<RopeLanes<F>>
{};

} // namespace
} // namespace box2d
