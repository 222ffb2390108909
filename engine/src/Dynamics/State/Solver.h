// SPDX-License-Identifier: MIT
#pragma once

#include "WorldSettings.h"

#include <Box2D/Common/Array.h>
#include <Box2D/Common/b2Math.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

#include <algorithm>
#include <span>

class b2Contact;
class b2ContactListener;

/// The solver's data: plain arrays of bodies and constraints, filled from the world at the start of
/// a step and written back at its end. Positions are displacements since the start of the step, so
/// that they stay exact far from the origin.
namespace box2d
{

/// One awake body. 32 bytes, so that two fit in a cache line.
struct alignas(32) SolverBody
{
    b2Vec2 v;          ///< velocity of the centre of mass [m/s]
    float32 w = 0;     ///< angular velocity [rad/s]
    float32 angle = 0; ///< rotation since the start of the step [rad]
    b2Vec2 d;          ///< displacement since the start of the step [m]
    b2Rot q;           ///< rotation since the start of the step

    /// Rotates by a small angle: to first order, then normalized.
    void Rotate(float32 delta)
    {
        const float32 s = q.s + delta * q.c;
        const float32 c = q.c - delta * q.s;
        const float32 inverseLength = b2InvSqrt(s * s + c * c);
        q.s = s * inverseLength;
        q.c = c * inverseLength;
        angle += delta;
    }
};

inline double KineticEnergy(const SolverBody& body, double mass, double inertia)
{
    const double x = body.v.x;
    const double y = body.v.y;
    const double w = body.w;
    return 0.5 * (mass * (x * x + y * y) + inertia * w * w);
}
/// Relative rounding error of a kinetic energy: some 80 roundings of a float. With 0 no test fails;
/// with 1e-3 impacts may add that much energy (docs/notes/tuned-constants.md).
inline constexpr double kEnergyRounding = 1e-5;

/// Maximum velocity [m/s], [rad/s]. Times the maximum mass of 1e20 kg (kMaxMass) it is 1e30, and
/// 1e38 with an arm of 1e8 m. Single precision ends at 3e38.
inline constexpr float32 kFastest = 1e10f;

/// Clamps to the maximum velocity; NaN becomes 0.
inline float32 Bounded(float32 speed)
{
    const bool tooFast = b2Abs(speed) > kFastest;
    return tooFast ? (speed > 0.0f ? kFastest : -kFastest) : (speed == speed ? speed : 0.0f);
}

inline b2Vec2 Bounded(const b2Vec2& velocity)
{
    return b2Vec2(Bounded(velocity.x), Bounded(velocity.y));
}

/// False if numbers exceed the range of the solver; its result is then discarded.
inline bool IsFinite(const SolverBody& body)
{
    return b2IsValid(body.v.x + body.v.y + body.w + body.d.x + body.d.y + body.angle);
}

/// The parameters of the step for joints and contacts, filled by MakeContext (Solver/StepSolver.h).
/// Code that only measures distances needs only the bodies.
struct SolverContext
{
    WorldSettings settings;
    SolverBody* bodies = nullptr; ///< by BodyData::SolverIndex; 0 never moves
    float32 timeStep = 0.0f;      ///< [s]
    float32 inverseStep = 0.0f;   ///< [1/s]
    float32 inverseWhole = 0.0f;  ///< the same of the whole step, also in a sub-step [1/s]
    float32 stepRatio = 1.0f; ///< this step's length divided by the last one's, for warm starting
    /// Time to the middle of the step [s]. Sub-steps take normals and levers of contacts from the
    /// poses at that time; 0: from those of the start.
    float32 middle = 0.0f;
    bool warmStarting = true; ///< that of the settings; false at impacts
    /// True in a step with sub-steps after another. The contacts' impulses are those of all of the
    /// last step, and only their last share still acts.
    bool warmStartsLastShare = false;
};

/// True if the solver may move the body of a constraint.
inline bool Moves(float32 invMass, float32 invInertia)
{
    return invMass > 0.0f || invInertia > 0.0f;
}

/// Two points are solved together while k11^2 < kMaxCondition * det. With c = k12 / k11 and equal
/// points the ratio is 1 / (1 - c^2). The condition number is (1 + c) / (1 - c), four times as
/// large, so at most 12 of the 24 bits of single precision are lost. The points of a 1 m box are
/// then 13 mm apart. Values from 30 to 1e5 are compared in docs/notes/contact-constants.md.
inline constexpr float32 kMaxCondition = 1000.0f;

/// The measure of a contact's overlap.
enum class OverlapKind : uint8
{
    Centers, ///< along the line between two points: circles
    FaceA,   ///< points of B against a line on A
    FaceB,   ///< points of A against a line on B
};

/// A body is fast if its displacement in a step exceeds this fraction of its thinnest half. It
/// could then pass through others, so continuous collision tests it. Two bodies that are not fast
/// approach in a step by a quarter of both halves at most. Contacts separate them to the right
/// side. Smaller values test more bodies. From 0.125 to 1 no test fails. With 1 a body of random
/// worlds 0 to 79 is up to 0.63 m out of the walls instead of 0.31 (one step). With 4 the ends of
/// rods that rotate get 0.22 m into a wall. With 0.0625 a row of 22 between walls gains 1.7 J/kg in
/// a step; its test allows 0.95.
inline constexpr float32 kFastShare = 0.25f;

/// Direction of an iteration over contacts: forward and backward alternate (symmetric Gauss-Seidel;
/// Saad, "Iterative Methods for Sparse Linear Systems", 4.1). Otherwise the order of colours would
/// push a tall stack to one side in every iteration.
enum class Direction : uint8
{
    Forward,
    Backward,
};

inline Direction DirectionOf(int32 iteration)
{
    return iteration % 2 == 0 ? Direction::Forward : Direction::Backward;
}

/// The direction for the velocities of coloured contacts, with as few reversals as possible. A
/// reversal solves a colour twice in a row, which wastes every other iteration of two colours and
/// softens stacks. Half of a step's iterations therefore go one way and half the other. The next
/// step starts from these impulses and continues in the last direction: `turned` in every other
/// step.
inline Direction ColorDirectionOf(int32 iteration, int32 count, bool turned)
{
    const bool second = iteration >= (count + 1) / 2;
    return second == turned ? Direction::Forward : Direction::Backward;
}

template <class List, class Function>
void ForEach(List&& list, Direction direction, Function&& function)
{
    if (direction == Direction::Forward)
    {
        std::for_each(list.begin(), list.end(), function);
    }
    else
    {
        std::for_each(list.rbegin(), list.rend(), function);
    }
}

/// Returns 1 / value, or 0 for value <= 0.
inline float32 InverseOrZero(float32 value)
{
    return value > 0.0f ? 1.0f / value : 0.0f;
}

} // namespace box2d
