// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

class b2DistanceJoint;

/// The solver of b2DistanceJoint, whose source has the formulas.
namespace box2d
{
namespace
{

template <class F>
struct DistanceLanes
{
    enum Features : uint8
    {
        kSpring = 1, ///< positions are not corrected
        kLimits = 2  ///< lower and upper limits
    };
    static constexpr uint8 kVelocityFeatures = kLimits;
    enum Form : uint8
    {
        kRodForm,
        kSpringForm,
        kLimitedForm, ///< limits, with or without a spring
    };

    F impulse;                    ///< of the rod or spring, along the axis [N s]
    F lowerImpulse, upperImpulse; ///< of the limits [N s], >= 0
    Vector<F> axis;
    Vector<F> armA, armB; ///< at the start of the step [m]
    Vector<F> offset;     ///< from centre of mass A to B [m]
    F mass;               ///< effective mass along the axis
    F bias, gamma;        ///< of a spring
    F length;             ///< rest length [m]
    F form;               ///< a Form

    /// Only for lanes with limits.
    struct Limits
    {
        F mass;                   ///< effective mass along the axis
        F lower, upper;           ///< [m]
        F lowerSpeed, upperSpeed; ///< that reach the limits in this step [m/s]
    };
    Limits limits;
    static constexpr int kLimitNumbers = int(sizeof(Limits) / sizeof(F));
    static constexpr int kPlainNumbers = 16; ///< before the limits
    static constexpr int kPlainImpulses = 1;
    static constexpr int kImpulses = 3;

    auto HasLimits() const { return AtLeast(form, F::Set(float32(kLimitedForm))); }

    void WarmStart(MovingPair<F>& pair, uint8 features) const
    {
        F all = impulse;
        if ((features & kLimits) != 0)
        {
            all = Select(HasLimits(), all + (lowerImpulse - upperImpulse), all);
        }
        pair.Apply(all * axis, armA, armB);
    }

    void SolveVelocity(MovingPair<F>& pair, uint8 features)
    {
        const F speed = Dot(axis, pair.PointSpeed(armA, armB));
        const F change = -mass * (speed + bias + gamma * impulse);
        impulse = impulse + change;
        pair.Apply(change * axis, armA, armB);
        if ((features & kLimits) != 0)
        {
            SolveLimits(pair);
        }
    }

    void SolveLimits(MovingPair<F>& pair)
    {
        const auto active = HasLimits();
        const F zero = F::Set(0.0f);
        const F inwards = Dot(axis, pair.PointSpeed(armA, armB)) + limits.lowerSpeed;
        const F up = Max(lowerImpulse - limits.mass * inwards, zero);
        ApplyAlongAxis(pair, up - lowerImpulse);
        lowerImpulse = Select(active, up, lowerImpulse);
        const F outwards = limits.upperSpeed - Dot(axis, pair.PointSpeed(armA, armB));
        const F down = Max(upperImpulse - limits.mass * outwards, zero);
        ApplyAlongAxis(pair, upperImpulse - down);
        upperImpulse = Select(active, down, upperImpulse);
    }

    /// Applies the limits, if there are any.
    void ApplyAlongAxis(MovingPair<F>& pair, F change) const
    {
        MovingPair<F> pushed = pair;
        pushed.Apply(change * axis, armA, armB);
        pair.Take(HasLimits(), pushed);
    }

    auto SolvePosition(PlacedPair<F>& pair, uint8 features) const
    {
        const F zero = F::Set(0.0f);
        const Vector<F> turnedA = pair.a.Turn(armA);
        const Vector<F> turnedB = pair.b.Turn(armB);
        Vector<F> along = pair.Offset(offset) + turnedB - turnedA;
        const F now = Normalize(along);
        const F maximum = F::Set(b2_maxLinearCorrection);
        F wanted = length;
        if ((features & kLimits) != 0)
        {
            wanted = Select(HasLimits(), Clamp(now, limits.lower, limits.upper), wanted);
        }
        const F error = Clamp(now - wanted, -maximum, maximum);
        const F k = pair.AxisMatrix(along, turnedA, turnedB);
        auto held = Not(Or(AtLeast(zero, now), AtLeast(zero, k)));
        auto joined = AtLeast(F::Set(b2_linearSlop), Abs(error));
        if ((features & kSpring) != 0)
        {
            const auto isSpring = And(IsSet(form), Not(HasLimits()));
            held = And(held, Not(isSpring));
            joined = Or(joined, isSpring);
        }
        PlacedPair<F> moved = pair;
        moved.Move((-error / Select(held, k, F::Set(1.0f))) * along, turnedA, turnedB);
        pair.Take(held, moved);
        return joined;
    }
};

template <class F>
struct LanesOf<b2DistanceJoint, F> : std::type_identity<DistanceLanes<F>>
{};

} // namespace
} // namespace box2d
