// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

class b2PrismaticJoint;

/// The solver of b2PrismaticJoint, whose source has the formulas.
namespace box2d
{
namespace
{

template <class F>
struct PrismaticLanes
{
    static constexpr int kImpulses = 4;
    static constexpr int kPlainImpulses = 2; ///< without features
    enum Features : uint8
    {
        kMotor = 1,
        kLimits = 2
    };

    /// The moments of the axis and of its perpendicular, about the centres of mass.
    struct Levers
    {
        F axisA, axisB;     ///< (d + rA) x a, rB x a
        F acrossA, acrossB; ///< (d + rA) x t, rB x t

        /// Returns the matrix of the two rows perpendicular to the axis and about it; 1 for two
        /// bodies that cannot rotate.
        typename PairMasses<F>::Matrix MatrixOf(const PairMasses<F>& pair) const
        {
            const F inertia = pair.iA + pair.iB;
            const auto turns = Not(AtLeast(F::Set(0.0f), inertia));
            return {pair.AxisMatrix(acrossA, acrossB), pair.iA * acrossA + pair.iB * acrossB,
                    Select(turns, inertia, F::Set(1.0f))};
        }

        /// The row along the axis while those two are held, as in HeldRow<F>::AngleOfPoint. With p
        /// and q the differences of the levers perpendicular and along
        ///   |K held| / (mA + mB)^2 = a + b + a b p^2
        ///   |K|      / (mA + mB)^3 = a + b + a b (p^2 + q^2)
        HeldRow<F> RowOf(const PairMasses<F>& pair) const
        {
            const F reduced = InverseOrZero(pair.mA + pair.mB);
            const F a = pair.iA * reduced;
            const F b = pair.iB * reduced;
            const F p = acrossA - acrossB;
            const F q = axisA - axisB;
            const F held = a + b + a * b * p * p;
            const F s = InverseOrZero(held); // 0 for two bodies that cannot rotate
            const F mass = reduced * InverseOrZero(F::Set(1.0f) + s * (a * b * q * q));
            const F turn = a * axisA + b * axisB + a * b * p * (acrossA * axisB - acrossB * axisA);
            return {mass, {-s * (a * b * p * q), -s * turn}};
        }
    };

    Vector<F> impulse;            ///< perpendicular to the axis [N s], angular [N m s]
    F motorImpulse, limitImpulse; ///< [N s]; the limit's is positive at the lower one
    Vector<F> axis;
    Levers levers;
    typename PairMasses<F>::Matrix inverse; ///< of the matrix perpendicular to and about the axis
    Vector<F> armA, armB;                   ///< at the start of the step [m]
    Vector<F> offset;                       ///< from centre of mass A to B [m]
    F angleError;                           ///< at the start of the step [rad]
    HeldRow<F> row;                         ///< along the axis, while the other two are held
    F hasMotor, hasLimits;                  ///< 1 or 0
    F motorSpeed, maxMotor;                 ///< [m/s], [N s]
    F lower, upper;                         ///< [m]
    F lowerSpeed, upperSpeed;               ///< that reach the limits in this step [m/s]

    void WarmStart(MovingPair<F>& pair, uint8) const
    {
        pair.ApplyAlong(axis, levers.axisA, levers.axisB, motorImpulse + limitImpulse);
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
        const Vector<F> speed = {pair.SpeedAlong(Skew(axis), levers.acrossA, levers.acrossB),
                                 pair.wB - pair.wA};
        const Vector<F> change = inverse * -speed;
        impulse = impulse + change;
        Apply(pair, change);
        if ((features & kMotor) != 0)
        {
            SolveMotor(pair);
        }
        if ((features & kLimits) != 0)
        {
            SolveLimits(pair);
        }
    }

    F AxialSpeed(const MovingPair<F>& pair) const
    {
        return pair.SpeedAlong(axis, levers.axisA, levers.axisB);
    }

    void SolveMotor(MovingPair<F>& pair)
    {
        const F wanted = motorImpulse + row.mass * (motorSpeed - AxialSpeed(pair));
        const F total = Clamp(wanted, -maxMotor, maxMotor);
        Push(pair, IsSet(hasMotor), total, motorImpulse);
    }

    void SolveLimits(MovingPair<F>& pair)
    {
        const F total =
            LimitImpulse(limitImpulse, row.mass, AxialSpeed(pair), lowerSpeed, upperSpeed);
        Push(pair, IsSet(hasLimits), total, limitImpulse);
    }

    /// Brings an impulse along the axis to its new total, with the reaction of the other two rows.
    template <class M>
    void Push(MovingPair<F>& pair, M active, F total, F& sum)
    {
        const F change = total - sum;
        const Vector<F> answer = change * row.reaction;
        MovingPair<F> pushed = pair;
        pushed.ApplyAlong(axis, levers.axisA, levers.axisB, change);
        Apply(pushed, answer);
        pair.Take(active, pushed);
        impulse = Select(active, impulse + answer, impulse);
        sum = Select(active, total, sum);
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
        const F limitError =
            (features & kLimits) != 0 ? PushBack(pair, along, now, Dot(along, d)) : F::Set(0.0f);
        const Vector<F> error = {Dot(across, d), angleError + pair.b.angle - pair.a.angle};
        const Vector<F> change = now.MatrixOf(pair).Solve(-error);
        Move(pair, along, now, change, F::Set(0.0f));
        return And(AtLeast(F::Set(b2_linearSlop), Max(Abs(error.x), limitError)),
                   AtLeast(F::Set(b2_angularSlop), Abs(error.y)));
    }

    static void Move(PlacedPair<F>& pair, const Vector<F>& along, const Levers& levers,
                     const Vector<F>& held, F axial)
    {
        const Vector<F> push = axial * along + held.x * Skew(along);
        pair.a.d = pair.a.d - pair.mA * push;
        pair.b.d = pair.b.d + pair.mB * push;
        pair.Rotate(levers.axisA * axial + levers.acrossA * held.x + held.y,
                    levers.axisB * axial + levers.acrossB * held.x + held.y);
    }

    /// Corrects a limit that is violated by more than a slop, with the other two rows held. Returns
    /// the violation, or 0 [m].
    F PushBack(PlacedPair<F>& pair, const Vector<F>& along, const Levers& now, F translation) const
    {
        const F zero = F::Set(0.0f);
        const F slop = F::Set(b2_linearSlop);
        const F back = BackTowards(lower, upper, translation, slop, F::Set(b2_maxLinearCorrection));
        const auto moves = And(IsSet(hasLimits), Not(AtLeast(zero, Abs(back))));
        if (Any(moves))
        {
            const auto held = now.RowOf(pair);
            const F push = held.mass * back;
            PlacedPair<F> moved = pair;
            Move(moved, along, now, push * held.reaction, push);
            pair.Take(moves, moved);
        }
        return Select(moves, Abs(back) + slop, zero);
    }
};

template <class F>
struct LanesOf<b2PrismaticJoint, F> : std::type_identity<PrismaticLanes<F>>
{};

} // namespace
} // namespace box2d
