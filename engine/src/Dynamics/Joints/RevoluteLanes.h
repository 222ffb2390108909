// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

#include <cstddef>

class b2RevoluteJoint;

/// The solver of b2RevoluteJoint, whose source has the formulas.
namespace box2d
{
namespace
{

template <class F>
struct RevoluteLanes
{
    static constexpr int kImpulses = 4;
    static constexpr int kPlainImpulses = 2; ///< without features
    enum Features : uint8
    {
        kMotor = 1,
        kLimits = 2
    };

    Vector<F> impulse;                      ///< linear [N s]
    F motorImpulse, limitImpulse;           ///< [N m s]; the limit's is positive at the lower one
    Vector<F> armA, armB;                   ///< at the start of the step [m]
    Vector<F> offset;                       ///< from centre of mass A to B [m]
    typename PairMasses<F>::Matrix inverse; ///< of the matrix of the point
    F hasMotor, hasLimits;                  ///< 1 or 0

    /// Only for lanes with a motor or limits.
    struct Axial
    {
        HeldRow<F> row;           ///< the angle, while the point is held
        F motorSpeed, maxMotor;   ///< [rad/s], [N m s]
        F angle, lower, upper;    ///< at the start of the step [rad]
        F lowerSpeed, upperSpeed; ///< that reach the limits in this step [rad/s]
    };
    Axial axial;
    static constexpr std::size_t kAxialNumbers = sizeof(Axial) / sizeof(F);

    void WarmStart(MovingPair<F>& pair, uint8) const
    {
        pair.Apply(impulse, armA, armB);
        pair.ApplyAngular(motorImpulse + limitImpulse);
    }

    /// Takes the arms, and what follows from them, from the present poses. Without features the
    /// first TurnedNumbers change.
    void Turn(const PlacedPair<F>& pair, const RevoluteLanes& start, uint8 features,
              const Kick& kick)
    {
        armA = pair.a.Turn(start.armA);
        armB = pair.b.Turn(start.armB);
        inverse = pair.PointMatrix(armA, armB).Inverse();
        if (features == 0)
        {
            return;
        }
        axial.row = HeldRow<F>::AngleOfPoint(pair, armA, armB);
        axial.maxMotor = F::Set(kick.share) * start.axial.maxMotor;
        const F zero = F::Set(0.0f);
        const F rate = F::Set(kick.inverseDrift);
        const F angle = start.axial.angle + pair.b.angle - pair.a.angle;
        axial.lowerSpeed = Max(angle - axial.lower, zero) * rate;
        axial.upperSpeed = Max(axial.upper - angle, zero) * rate;
    }

    static constexpr int TurnedNumbers()
    {
        return int(offsetof(RevoluteLanes, hasMotor) / sizeof(F));
    }

    void SolveVelocity(MovingPair<F>& pair, uint8 features)
    {
        const Vector<F> change = inverse * -pair.PointSpeed(armA, armB);
        impulse = impulse + change;
        pair.Apply(change, armA, armB);
        if ((features & kMotor) != 0)
        {
            SolveMotor(pair);
        }
        if ((features & kLimits) != 0)
        {
            SolveLimits(pair);
        }
    }

    void SolveMotor(MovingPair<F>& pair)
    {
        const F speed = pair.wB - pair.wA - axial.motorSpeed;
        const F total =
            Clamp(motorImpulse - axial.row.mass * speed, -axial.maxMotor, axial.maxMotor);
        Turn(pair, IsSet(hasMotor), total, motorImpulse);
    }

    void SolveLimits(MovingPair<F>& pair)
    {
        const F speed = pair.wB - pair.wA;
        const F total =
            LimitImpulse(limitImpulse, axial.row.mass, speed, axial.lowerSpeed, axial.upperSpeed);
        Turn(pair, IsSet(hasLimits), total, limitImpulse);
    }

    /// Brings an impulse about the hinge to its new total, with the reaction of the point.
    template <class M>
    void Turn(MovingPair<F>& pair, M active, F total, F& sum)
    {
        const F change = total - sum;
        const Vector<F> answer = change * axial.row.reaction;
        MovingPair<F> turned = pair;
        turned.Apply(answer, armA, armB);
        turned.ApplyAngular(change);
        pair.Take(active, turned);
        impulse = Select(active, impulse + answer, impulse);
        sum = Select(active, total, sum);
    }

    auto SolvePosition(PlacedPair<F>& pair, uint8 features) const
    {
        const F angularError = (features & kLimits) != 0 ? TurnBack(pair) : F::Set(0.0f);
        const Vector<F> turnedA = pair.a.Turn(armA);
        const Vector<F> turnedB = pair.b.Turn(armB);
        const Vector<F> error = pair.Offset(offset) + turnedB - turnedA;
        pair.Move(pair.PointMatrix(turnedA, turnedB).Solve(-error), turnedA, turnedB);
        return And(LengthIsWithin(error, F::Set(b2_linearSlop)),
                   AtLeast(F::Set(b2_angularSlop), angularError));
    }

    /// Corrects a limit that is violated by more than a slop, with the point held. Returns the
    /// violation, or 0 [rad].
    F TurnBack(PlacedPair<F>& pair) const
    {
        const F zero = F::Set(0.0f);
        const F now = axial.angle + pair.b.angle - pair.a.angle;
        const F slop = F::Set(b2_angularSlop);
        const F back =
            BackTowards(axial.lower, axial.upper, now, slop, F::Set(b2_maxAngularCorrection));
        const auto turns = And(IsSet(hasLimits), Not(AtLeast(zero, Abs(back))));
        if (Any(turns))
        {
            const Vector<F> turnedA = pair.a.Turn(armA);
            const Vector<F> turnedB = pair.b.Turn(armB);
            const auto row = HeldRow<F>::AngleOfPoint(pair, turnedA, turnedB);
            const F turn = row.mass * back;
            const Vector<F> push = turn * row.reaction;
            PlacedPair<F> moved = pair;
            moved.a.d = moved.a.d - pair.mA * push;
            moved.b.d = moved.b.d + pair.mB * push;
            moved.Rotate(Cross(turnedA, push) + turn, Cross(turnedB, push) + turn);
            pair.Take(turns, moved);
        }
        return Select(turns, Abs(back) + slop, zero);
    }
};

template <class F>
struct LanesOf<b2RevoluteJoint, F> : std::type_identity<RevoluteLanes<F>>
{};

} // namespace
} // namespace box2d
