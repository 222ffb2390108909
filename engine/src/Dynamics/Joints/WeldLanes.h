// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

class b2WeldJoint;

/// The solver of b2WeldJoint, whose source has the formulas.
namespace box2d
{
namespace
{

template <class F>
struct WeldLanes
{
    static constexpr int kImpulses = 3;
    static constexpr int kPlainImpulses = kImpulses;
    enum Features : uint8
    {
        kRigid = 1,
        kSoft = 2
    };

    Vector<F> impulse;          ///< linear [N s]
    F angularImpulse;           ///< [N m s]
    Vector<F> armA, armB;       ///< at the start of the step [m]
    Vector<F> offset;           ///< from centre of mass A to B [m]
    F angleError;               ///< at the start of the step [rad]
    F isRigid;                  ///< 1, or 0 if the angle has a spring or cannot change
    F angularMass, bias, gamma; ///< of the spring

    void WarmStart(MovingPair<F>& pair, uint8) const
    {
        pair.Apply(impulse, armA, armB);
        pair.ApplyAngular(angularImpulse);
    }

    /// The matrix of the three rows together, solved by Cramer's rule with the columns' cross
    /// products as cofactors:
    ///   K = [ PointMatrix   k ; k^T   iA + iB ].
    struct Full
    {
        F xx, xy, yy, xw, yw, ww;

        Full(const PairMasses<F>& pair, const Vector<F>& rA, const Vector<F>& rB)
        {
            const auto point = pair.PointMatrix(rA, rB);
            xx = point.k11;
            xy = point.k12;
            yy = point.k22;
            xw = -pair.iA * rA.y - pair.iB * rB.y;
            yw = pair.iA * rA.x + pair.iB * rB.x;
            ww = pair.iA + pair.iB;
        }
        /// Solves for (x, y, w); the result is zero if the matrix is singular.
        void Solve(Vector<F>& b, F& w) const
        {
            const F cofactorX = yy * ww - yw * yw;
            const F cofactorY = yw * xw - xy * ww;
            const F cofactorW = xy * yw - yy * xw;
            const F s = InverseUnlessZero(xx * cofactorX + xy * cofactorY + xw * cofactorW);
            const F x = s * (b.x * cofactorX + b.y * cofactorY + w * cofactorW);
            const F y = s * (xx * (b.y * ww - w * yw) + xy * (w * xw - b.x * ww) +
                             xw * (b.x * yw - b.y * xw));
            w = s *
                (xx * (yy * w - yw * b.y) + xy * (yw * b.x - xy * w) + xw * (xy * b.y - yy * b.x));
            b = {x, y};
        }
    };

    void SolveVelocity(MovingPair<F>& pair, uint8 features)
    {
        WeldLanes soft = *this;
        MovingPair<F> softPair = pair;
        if ((features & kSoft) != 0)
        {
            soft.SolveSoft(softPair);
        }
        if ((features & kRigid) != 0)
        {
            SolveRigid(pair);
        }
        const auto springs = Not(IsSet(isRigid));
        pair.Take(springs, softPair);
        impulse = Select(springs, soft.impulse, impulse);
        angularImpulse = Select(springs, soft.angularImpulse, angularImpulse);
    }

    void SolveSoft(MovingPair<F>& pair)
    {
        const F turn = -angularMass * (pair.wB - pair.wA + bias + gamma * angularImpulse);
        angularImpulse = angularImpulse + turn;
        pair.ApplyAngular(turn);
        const Vector<F> push = pair.PointMatrix(armA, armB).Solve(-pair.PointSpeed(armA, armB));
        impulse = impulse + push;
        pair.Apply(push, armA, armB);
    }

    void SolveRigid(MovingPair<F>& pair)
    {
        Vector<F> push = -pair.PointSpeed(armA, armB);
        F turn = pair.wA - pair.wB;
        Full(pair, armA, armB).Solve(push, turn);
        impulse = impulse + push;
        angularImpulse = angularImpulse + turn;
        pair.Apply(push, armA, armB);
        pair.ApplyAngular(turn);
    }

    auto SolvePosition(PlacedPair<F>& pair, uint8) const
    {
        const Vector<F> turnedA = pair.a.Turn(armA);
        const Vector<F> turnedB = pair.b.Turn(armB);
        const Vector<F> error = pair.Offset(offset) + turnedB - turnedA;
        const F angularError = angleError + pair.b.angle - pair.a.angle;
        Vector<F> push = -error;
        F turn = -angularError;
        Full(pair, turnedA, turnedB).Solve(push, turn);
        const auto rigid = IsSet(isRigid);
        push = Select(rigid, push, pair.PointMatrix(turnedA, turnedB).Solve(-error));
        const F leverA = Cross(turnedA, push);
        const F leverB = Cross(turnedB, push);
        pair.a.d = pair.a.d - pair.mA * push;
        pair.b.d = pair.b.d + pair.mB * push;
        pair.Rotate(Select(rigid, leverA + turn, leverA), Select(rigid, leverB + turn, leverB));
        return And(LengthIsWithin(error, F::Set(b2_linearSlop)),
                   Or(Not(rigid), AtLeast(F::Set(b2_angularSlop), Abs(angularError))));
    }
};

template <class F>
struct LanesOf<b2WeldJoint, F> : std::type_identity<WeldLanes<F>>
{};

} // namespace
} // namespace box2d
