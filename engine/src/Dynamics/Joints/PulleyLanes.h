// SPDX-License-Identifier: MIT
#pragma once

#include "JointLanes.h"

class b2PulleyJoint;

/// The solver of b2PulleyJoint, whose source has the formulas.
namespace box2d
{
namespace
{

/// A shorter rope [m] has no direction, and its length counts as constant: motion of its end causes
/// no force. The limit is that of Box2D 2.3. The slop turns a rope of ten slops by 0.1 rad at most.
/// With ten times as much a rope gets 0.4 m too short; with a tenth no test changes.
constexpr float32 kShortestRope = 10.0f * b2_linearSlop;

template <class F>
struct PulleyLanes
{
    static constexpr int kImpulses = 1;
    static constexpr int kPlainImpulses = kImpulses;

    F impulse;              ///< in A's rope [N s]
    Vector<F> axisA, axisB; ///< from the ground anchors to the bodies'
    Vector<F> armA, armB;   ///< at the start of the step [m]
    Vector<F> ropeA, ropeB; ///< from the ground anchors to the centres of mass, then [m]
    F ratio;
    F mass;             ///< effective mass
    F lengthA, lengthB; ///< [m]

    void WarmStart(MovingPair<F>& pair, uint8) const { Pull(pair, impulse); }

    void SolveVelocity(MovingPair<F>& pair, uint8)
    {
        const F speed = Dot(axisA, pair.vA + Cross(pair.wA, armA)) +
                        ratio * Dot(axisB, pair.vB + Cross(pair.wB, armB));
        const F change = mass * speed;
        impulse = impulse + change;
        Pull(pair, change);
    }

    void Pull(MovingPair<F>& pair, F by) const
    {
        const Vector<F> onA = -by * axisA;
        const Vector<F> onB = (-ratio * by) * axisB;
        pair.vA = pair.vA + pair.mA * onA;
        pair.wA = pair.wA + pair.iA * Cross(armA, onA);
        pair.vB = pair.vB + pair.mB * onB;
        pair.wB = pair.wB + pair.iB * Cross(armB, onB);
    }

    static Vector<F> Direction(const Vector<F>& rope)
    {
        const F zero = F::Set(0.0f);
        const F length = Length(rope);
        const auto near = AtLeast(F::Set(kShortestRope), length);
        const F inverse = F::Set(1.0f) / Select(near, F::Set(1.0f), length);
        return Select(near, Vector<F>{zero, zero}, inverse * rope);
    }
    static F RopeLength(const Vector<F>& rope) { return Max(Length(rope), F::Set(kShortestRope)); }

    auto SolvePosition(PlacedPair<F>& pair, uint8) const
    {
        const Vector<F> turnedA = pair.a.Turn(armA);
        const Vector<F> turnedB = pair.b.Turn(armB);
        const Vector<F> nowA = ropeA + pair.a.d + turnedA;
        const Vector<F> nowB = ropeB + pair.b.d + turnedB;
        const Vector<F> alongA = Direction(nowA);
        const Vector<F> alongB = Direction(nowB);
        const F leverA = Cross(turnedA, alongA);
        const F leverB = Cross(turnedB, alongB);
        const F k = pair.mA + pair.iA * leverA * leverA +
                    ratio * ratio * (pair.mB + pair.iB * leverB * leverB);
        const F error = RopeLength(nowA) - lengthA + ratio * (RopeLength(nowB) - lengthB);
        // At most what velocities may move: each iteration would move a light body between a pulley
        // and a limit further out. With 0.2 m, as for rods, ropes stretch.
        const F maximum = F::Set(b2_maxTranslation);
        const F push = -Clamp(error, -maximum, maximum) * InverseOrZero(k);
        pair.a.d = pair.a.d + pair.mA * (push * alongA);
        pair.b.d = pair.b.d + pair.mB * ((ratio * push) * alongB);
        pair.Rotate(-Cross(turnedA, push * alongA), Cross(turnedB, (ratio * push) * alongB));
        return AtLeast(F::Set(b2_linearSlop), Abs(error));
    }
};

template <class F>
struct LanesOf<b2PulleyJoint, F> : std::type_identity<PulleyLanes<F>>
{};

} // namespace
} // namespace box2d
