// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

class b2FrictionJoint;

/// The solver of b2FrictionJoint, whose source has the formulas; with a wanted speed that of
/// b2MotorJoint as well.
namespace box2d
{
namespace
{

template <class F>
struct FrictionLanes
{
    static constexpr int kImpulses = 3;
    static constexpr int kPlainImpulses = kImpulses;

    Vector<F> impulse;                      ///< [N s]
    F angularImpulse;                       ///< [N m s]
    F maximum, maxAngular;                  ///< their maximum
    Vector<F> armA, armB;                   ///< at the start of the step [m]
    typename PairMasses<F>::Matrix inverse; ///< of the matrix of the point
    F angularMass;

    void WarmStart(MovingPair<F>& pair, uint8) const
    {
        pair.Apply(impulse, armA, armB);
        pair.ApplyAngular(angularImpulse);
    }

    void SolveVelocity(MovingPair<F>& pair, uint8)
    {
        SolveAngular(pair, pair.wB - pair.wA);
        SolveLinear(pair, pair.PointSpeed(armA, armB));
    }

    void SolveAngular(MovingPair<F>& pair, F speed)
    {
        const F total = Clamp(angularImpulse - angularMass * speed, -maxAngular, maxAngular);
        pair.ApplyAngular(total - angularImpulse);
        angularImpulse = total;
    }
    void SolveLinear(MovingPair<F>& pair, const Vector<F>& speed)
    {
        const Vector<F> wanted = impulse + inverse * -speed;
        const Vector<F> total = ClampLength(wanted, maximum);
        pair.Apply(total - impulse, armA, armB);
        impulse = total;
    }
};

template <class F>
struct LanesOf<b2FrictionJoint, F> : std::type_identity<FrictionLanes<F>>
{};

} // namespace
} // namespace box2d
