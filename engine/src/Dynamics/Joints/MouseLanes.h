// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

class b2MouseJoint;

/// The solver of b2MouseJoint, whose source has the formulas. Body A takes no part.
namespace box2d
{
namespace
{

template <class F>
struct MouseLanes
{
    static constexpr int kImpulses = 2;
    static constexpr int kPlainImpulses = kImpulses;
    /// Fraction of the angular velocity kept per step, so that a dragged body does not spin for
    /// long. The number is that of Box2D 2.3: 0.98^60 leaves 30 % after a second at 60 Hz.
    static constexpr float32 kKeptSpin = 0.98f;

    Vector<F> impulse;                      ///< [N s]
    F maximum;                              ///< its maximum
    Vector<F> arm;                          ///< at the start of the step [m]
    typename PairMasses<F>::Matrix inverse; ///< of the matrix of the point
    Vector<F> bias;
    F gamma;

    void WarmStart(MovingPair<F>& pair, uint8) const
    {
        pair.wB = pair.wB * F::Set(kKeptSpin);
        Apply(pair, impulse);
    }
    void SolveVelocity(MovingPair<F>& pair, uint8)
    {
        const Vector<F> speed = pair.vB + Cross(pair.wB, arm) + bias + gamma * impulse;
        const Vector<F> total = ClampLength(impulse + inverse * -speed, maximum);
        Apply(pair, total - impulse);
        impulse = total;
    }
    void Apply(MovingPair<F>& pair, const Vector<F>& push) const
    {
        pair.vB = pair.vB + pair.mB * push;
        pair.wB = pair.wB + pair.iB * Cross(arm, push);
    }
};

template <class F>
struct LanesOf<b2MouseJoint, F> : std::type_identity<MouseLanes<F>>
{};

} // namespace
} // namespace box2d
