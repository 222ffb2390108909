// SPDX-License-Identifier: MIT
#pragma once

#include "../JointLanes.h"

/// The solver of b2RevoluteJoint, whose source has the formulas.
namespace box2d
{
namespace
{

template <class F>
struct RevoluteLanes
{
    static constexpr int kImpulses = 5;
    static constexpr int kPlainImpulses = 2; ///< without features
    static constexpr bool kHoldsPositions = true;
    enum Features : uint8
    {
        kMotor = 1,
        kLimits = 2
    };

    Vector<F> impulse;                          ///< of the point [N s]
    F motorImpulse, lowerImpulse, upperImpulse; ///< [N m s]
    Vector<F> armA, armB;                       ///< at the start of the step [m]
    Vector<F> offset;                           ///< from centre of mass A to B [m]
    typename PairMasses<F>::Matrix matrix;      ///< of the point
    F inverse;                                  ///< 1 over its determinant
    F hasMotor, hasLimits;                      ///< 1 or 0

    /// Written of lanes with a motor or limits only.
    struct Axial
    {
        F mass;                   ///< effective
        F motorSpeed, mostMotor;  ///< [rad/s], [N m s]
        F angle, lower, upper;    ///< at the start of the step [rad]
        F lowerSpeed, upperSpeed; ///< that reach the limits in this step [rad/s]
    };
    Axial axial;
    static constexpr std::size_t kAxialNumbers = sizeof(Axial) / sizeof(F);

    void WarmStart(MovingPair<F>& pair, uint8) const
    {
        pair.Apply(impulse, armA, armB);
        pair.ApplyAngular(motorImpulse + lowerImpulse - upperImpulse);
    }

    void SolveVelocity(MovingPair<F>& pair, uint8 features)
    {
        if ((features & kMotor) != 0)
        {
            SolveMotor(pair);
        }
        if ((features & kLimits) != 0)
        {
            SolveLimits(pair);
        }
        const Vector<F> change = matrix.Solve(-pair.PointSpeed(armA, armB), inverse);
        impulse = impulse + change;
        pair.Apply(change, armA, armB);
    }

    void SolveMotor(MovingPair<F>& pair)
    {
        const F speed = pair.wB - pair.wA - axial.motorSpeed;
        const F total = Clamp(motorImpulse - axial.mass * speed, -axial.mostMotor, axial.mostMotor);
        ApplyAngular(pair, hasMotor, total - motorImpulse);
        motorImpulse = Select(IsSet(hasMotor), total, motorImpulse);
    }

    void SolveLimits(MovingPair<F>& pair)
    {
        const auto active = IsSet(hasLimits);
        const F zero = F::Set(0.0f);
        const F up = Max(lowerImpulse - axial.mass * (pair.wB - pair.wA + axial.lowerSpeed), zero);
        ApplyAngular(pair, hasLimits, up - lowerImpulse);
        lowerImpulse = Select(active, up, lowerImpulse);
        const F down =
            Max(upperImpulse - axial.mass * (pair.wA - pair.wB + axial.upperSpeed), zero);
        ApplyAngular(pair, hasLimits, upperImpulse - down);
        upperImpulse = Select(active, down, upperImpulse);
    }

    static void ApplyAngular(MovingPair<F>& pair, F flag, F change)
    {
        MovingPair<F> pushed = pair;
        pushed.ApplyAngular(change);
        pair.Take(IsSet(flag), pushed);
    }

    auto SolvePosition(PlacedPair<F>& pair, uint8 features) const
    {
        F angularError = F::Set(0.0f);
        if ((features & kLimits) != 0)
        {
            const F now = axial.angle + pair.b.angle - pair.a.angle;
            const F inside = Clamp(now, axial.lower, axial.upper);
            const F most = F::Set(b2_maxAngularCorrection);
            const F turn = axial.mass * Clamp(inside - now, -most, most);
            PlacedPair<F> turned = pair;
            turned.Rotate(turn, turn);
            pair.Take(IsSet(hasLimits), turned);
            angularError = Select(IsSet(hasLimits), Abs(now - inside), angularError);
        }
        const Vector<F> turnedA = pair.a.Turn(armA);
        const Vector<F> turnedB = pair.b.Turn(armB);
        const Vector<F> error = pair.Offset(offset) + turnedB - turnedA;
        pair.Move(pair.PointMatrix(turnedA, turnedB).Solve(-error), turnedA, turnedB);
        return And(AtLeast(F::Set(b2_linearSlop), Length(error)),
                   AtLeast(F::Set(b2_angularSlop), angularError));
    }
};

} // namespace
} // namespace box2d
