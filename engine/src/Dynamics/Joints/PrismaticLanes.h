// SPDX-License-Identifier: MIT
#pragma once

#include "../JointLanes.h"

/// The solver of b2PrismaticJoint, whose source has the formulas.
namespace box2d
{
namespace
{

template <class F>
struct PrismaticLanes
{
    static constexpr int kImpulses = 5;
    static constexpr int kPlainImpulses = 2; ///< without features
    static constexpr bool kHoldsPositions = true;
    enum Features : uint8
    {
        kMotor = 1,
        kLimits = 2
    };

    /// The moments of the axis and of what is across it, about the centres of mass.
    struct Levers
    {
        F axisA, axisB;     ///< (d + rA) x a, rB x a
        F acrossA, acrossB; ///< (d + rA) x t, rB x t

        /// Of the two rows across the axis and about it; 1 for two bodies that cannot turn.
        typename PairMasses<F>::Matrix MatrixOf(const PairMasses<F>& pair) const
        {
            const F inertia = pair.iA + pair.iB;
            const auto turns = Not(AtLeast(F::Set(0.0f), inertia));
            return {pair.AxisMatrix(acrossA, acrossB), pair.iA * acrossA + pair.iB * acrossB,
                    Select(turns, inertia, F::Set(1.0f))};
        }
    };

    Vector<F> impulse;                          ///< across the axis [N s], against turning [N m s]
    F motorImpulse, lowerImpulse, upperImpulse; ///< along the axis [N s]
    Vector<F> axis;
    Levers levers;
    typename PairMasses<F>::Matrix matrix; ///< across and about the axis
    F inverse;                             ///< 1 over its determinant
    Vector<F> armA, armB;                  ///< at the start of the step [m]
    Vector<F> offset;                      ///< from centre of mass A to B [m]
    F angleError;                          ///< at the start of the step [rad]
    F axialMass;                           ///< effective
    F hasMotor, hasLimits;                 ///< 1 or 0
    F motorSpeed, mostMotor;               ///< [m/s], [N s]
    F lower, upper;                        ///< [m]
    F lowerSpeed, upperSpeed;              ///< that reach the limits in this step [m/s]

    void WarmStart(MovingPair<F>& pair, uint8) const
    {
        pair.ApplyAlong(axis, levers.axisA, levers.axisB,
                        motorImpulse + lowerImpulse - upperImpulse);
        Apply(pair, impulse);
    }

    void Apply(MovingPair<F>& pair, const Vector<F>& change) const
    {
        const Vector<F> across = Skew(axis);
        pair.vA = pair.vA - (pair.mA * change.x) * across;
        pair.wA = pair.wA - pair.iA * (levers.acrossA * change.x + change.y);
        pair.vB = pair.vB + (pair.mB * change.x) * across;
        pair.wB = pair.wB + pair.iB * (levers.acrossB * change.x + change.y);
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
        const Vector<F> speed = {pair.SpeedAlong(Skew(axis), levers.acrossA, levers.acrossB),
                                 pair.wB - pair.wA};
        const Vector<F> change = matrix.Solve(-speed, inverse);
        impulse = impulse + change;
        Apply(pair, change);
    }

    F AxialSpeed(const MovingPair<F>& pair) const
    {
        return pair.SpeedAlong(axis, levers.axisA, levers.axisB);
    }
    template <class M>
    void ApplyAxial(MovingPair<F>& pair, M active, F change) const
    {
        MovingPair<F> pushed = pair;
        pushed.ApplyAlong(axis, levers.axisA, levers.axisB, change);
        pair.Take(active, pushed);
    }

    void SolveMotor(MovingPair<F>& pair)
    {
        const auto active = IsSet(hasMotor);
        const F wanted = motorImpulse + axialMass * (motorSpeed - AxialSpeed(pair));
        const F total = Clamp(wanted, -mostMotor, mostMotor);
        ApplyAxial(pair, active, total - motorImpulse);
        motorImpulse = Select(active, total, motorImpulse);
    }

    void SolveLimits(MovingPair<F>& pair)
    {
        const auto active = IsSet(hasLimits);
        const F zero = F::Set(0.0f);
        const F up = Max(lowerImpulse - axialMass * (AxialSpeed(pair) + lowerSpeed), zero);
        ApplyAxial(pair, active, up - lowerImpulse);
        lowerImpulse = Select(active, up, lowerImpulse);
        const F down = Max(upperImpulse - axialMass * (upperSpeed - AxialSpeed(pair)), zero);
        ApplyAxial(pair, active, upperImpulse - down);
        upperImpulse = Select(active, down, upperImpulse);
    }

    auto SolvePosition(PlacedPair<F>& pair, uint8 features) const
    {
        const Vector<F> turnedA = pair.a.Turn(armA);
        const Vector<F> turnedB = pair.b.Turn(armB);
        const Vector<F> reachA = pair.Offset(offset) + turnedB; // d + rA
        const Vector<F> d = reachA - turnedA;
        const Vector<F> along = pair.a.Turn(axis);
        const Vector<F> across = Skew(along);
        const Levers now = {Cross(reachA, along), Cross(turnedB, along), Cross(reachA, across),
                            Cross(turnedB, across)};
        F limitError = F::Set(0.0f);
        if ((features & kLimits) != 0)
        {
            limitError = SolveLimitPosition(pair, along, now, Dot(along, d));
        }
        const Vector<F> error = {Dot(across, d), angleError + pair.b.angle - pair.a.angle};
        const Vector<F> change = now.MatrixOf(pair).Solve(-error);
        pair.a.d = pair.a.d - (pair.mA * change.x) * across;
        pair.b.d = pair.b.d + (pair.mB * change.x) * across;
        pair.Rotate(now.acrossA * change.x + change.y, now.acrossB * change.x + change.y);
        return And(AtLeast(F::Set(b2_linearSlop), Max(Abs(error.x), limitError)),
                   AtLeast(F::Set(b2_angularSlop), Abs(error.y)));
    }

    /// Returns the error [m].
    F SolveLimitPosition(PlacedPair<F>& pair, const Vector<F>& along, const Levers& now,
                         F translation) const
    {
        const F inside = Clamp(translation, lower, upper);
        const F most = F::Set(b2_maxLinearCorrection);
        const F push = Clamp(inside - translation, -most, most);
        PlacedPair<F> moved = pair;
        moved.MoveAlong(along, now.axisA, now.axisB,
                        push * InverseOrZero(pair.AxisMatrix(now.axisA, now.axisB)));
        pair.Take(IsSet(hasLimits), moved);
        return Select(IsSet(hasLimits), Abs(translation - inside), F::Set(0.0f));
    }
};

} // namespace
} // namespace box2d
