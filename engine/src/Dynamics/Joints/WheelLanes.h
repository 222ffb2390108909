// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

class b2WheelJoint;

/// The solver of b2WheelJoint, whose source has the formulas.
namespace box2d
{
namespace
{

template <class F>
struct WheelLanes
{
    static constexpr int kImpulses = 3;
    static constexpr int kPlainImpulses = 2; ///< without features
    enum Features : uint8
    {
        kMotor = 1
    };

    F impulse, springImpulse; ///< perpendicular to the axis and along it [N s]
    F motorImpulse;           ///< [N m s]
    Vector<F> axis;
    F axisA, axisB;       ///< its moments about the centres of mass: (d + rA) x a, rB x a
    F acrossA, acrossB;   ///< moments of its perpendicular
    Vector<F> armA, armB; ///< at the start of the step [m]
    Vector<F> offset;     ///< from centre of mass A to B [m]
    F rigidMass;          ///< effective mass, perpendicular
    F springMass, bias, gamma;
    F motorMass;
    F hasMotor;             ///< 1 or 0
    F motorSpeed, maxMotor; ///< [rad/s], [N m s]

    void WarmStart(MovingPair<F>& pair, uint8) const
    {
        pair.ApplyAlong(Skew(axis), acrossA, acrossB, impulse);
        pair.ApplyAlong(axis, axisA, axisB, springImpulse);
        pair.ApplyAngular(motorImpulse);
    }

    void SolveVelocity(MovingPair<F>& pair, uint8 features)
    {
        const F springSpeed = pair.SpeedAlong(axis, axisA, axisB);
        const F push = -springMass * (springSpeed + bias + gamma * springImpulse);
        springImpulse = springImpulse + push;
        pair.ApplyAlong(axis, axisA, axisB, push);
        if ((features & kMotor) != 0)
        {
            SolveMotor(pair);
        }
        const F change = -rigidMass * pair.SpeedAlong(Skew(axis), acrossA, acrossB);
        impulse = impulse + change;
        pair.ApplyAlong(Skew(axis), acrossA, acrossB, change);
    }

    void SolveMotor(MovingPair<F>& pair)
    {
        const F speed = pair.wB - pair.wA - motorSpeed;
        const F total = Clamp(motorImpulse - motorMass * speed, -maxMotor, maxMotor);
        MovingPair<F> driven = pair;
        driven.ApplyAngular(total - motorImpulse);
        pair.Take(IsSet(hasMotor), driven);
        motorImpulse = Select(IsSet(hasMotor), total, motorImpulse);
    }

    auto SolvePosition(PlacedPair<F>& pair, uint8) const
    {
        const Vector<F> turnedA = pair.a.Turn(armA);
        const Vector<F> turnedB = pair.b.Turn(armB);
        const Vector<F> reachA = pair.Offset(offset) + turnedB;
        const Vector<F> across = Skew(pair.a.Turn(axis));
        const F leverA = Cross(reachA, across);
        const F leverB = Cross(turnedB, across);
        const F error = Dot(across, reachA - turnedA);
        const F k = pair.AxisMatrix(leverA, leverB);
        pair.MoveAlong(across, leverA, leverB, -error * InverseOrZero(k));
        return AtLeast(F::Set(b2_linearSlop), Abs(error));
    }
};

template <class F>
struct LanesOf<b2WheelJoint, F> : std::type_identity<WheelLanes<F>>
{};

} // namespace
} // namespace box2d
