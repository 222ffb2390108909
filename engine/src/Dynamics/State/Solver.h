// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Common/b2Math.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

#include <algorithm>
#include <span>

class b2Contact;
class b2ContactListener;

/// What the solver works on: plain arrays of what moves and what constrains it, filled from the
/// world at the start of a step and written back at its end. Positions are kept as changes since
/// the start of the step, so that they stay exact far from the origin.
namespace box2d
{

/// One awake body. 32 bytes, two to a cache line.
struct alignas(32) SolverBody
{
    b2Vec2 v;          ///< velocity of the centre of mass [m/s]
    float32 w = 0;     ///< angular velocity [rad/s]
    float32 angle = 0; ///< turned since the start of the step [rad]
    b2Vec2 d;          ///< moved since the start of the step [m]
    b2Rot q;           ///< turned since the start of the step

    /// Turns by a small angle: to first order, then back to unit length.
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

/// Faster than this is a mistake [m/s], [rad/s]: it would overflow in products with masses and
/// arms.
inline constexpr float32 kFastest = 1e10f;

/// Within the above; what is no number counts as nothing.
inline float32 Bounded(float32 speed)
{
    const bool tooFast = b2Abs(speed) > kFastest;
    return tooFast ? (speed > 0.0f ? kFastest : -kFastest) : (speed == speed ? speed : 0.0f);
}

inline b2Vec2 Bounded(const b2Vec2& velocity)
{
    return b2Vec2(Bounded(velocity.x), Bounded(velocity.y));
}

/// False when numbers have become too large for the solver after all; it then had better done
/// nothing.
inline bool IsFinite(const SolverBody& body)
{
    return b2IsValid(body.v.x + body.v.y + body.w + body.d.x + body.d.y + body.angle);
}

/// What joints and contacts need to know of the step.
struct SolverContext
{
    SolverBody* bodies = nullptr; ///< by BodyData::SolverIndex; 0 never moves
    float32 timeStep = 0.0f;      ///< [s]
    float32 inverseStep = 0.0f;   ///< [1/s]
    float32 stepRatio =
        1.0f; ///< this step's length over the last one's, for the impulses carried over
    bool warmStarting = true;
};

/// The levers are the moments of a unit impulse at the point about the centres of mass [m]: arm
/// times direction. The tangent is the normal turned clockwise.
struct ContactPoint
{
    float32 normalLeverA, normalLeverB;
    float32 tangentLeverA, tangentLeverB;
    float32 normalImpulse;
    float32 tangentImpulse;
    float32 normalMass;  ///< effective
    float32 tangentMass; ///< effective
    float32 bias;        ///< approach speed that shall come back [m/s]
};

/// Whether the solver may move the body of a constraint.
inline bool Moves(float32 invMass, float32 invInertia)
{
    return invMass > 0.0f || invInertia > 0.0f;
}

/// The velocity side of one touching contact.
struct ContactConstraint
{
    ContactPoint points[2];
    b2Vec2 normal; ///< from A to B
    float32 friction;
    float32 tangentSpeed;
    float32 invMassA, invInertiaA, invMassB, invInertiaB;
    int32 bodyA, bodyB; ///< solver index
    int32 pointCount;
    bool coupled;          ///< the two points are solved together
    float32 k11, k12, k22; ///< how an impulse at one point changes the normal speed at either
    b2Contact* contact;
};

/// Two points are solved together while k11^2 < kMaxCondition * det. With c = k12 / k11 and equal
/// points the ratio is 1 / (1 - c^2) and the condition number (1 + c) / (1 - c), four times as
/// large: 12 of the 24 bits of single precision are lost at most. Points of a box of 1 m then are
/// 13 mm apart. Measured between 30 and 1e5: docs/notes/contact-constants.md.
inline constexpr float32 kMaxCondition = 1000.0f;

/// Where a contact's overlap is measured.
enum class OverlapKind : uint8
{
    Centers, ///< along the line between two points: circles
    FaceA,   ///< points of B against a line on A
    FaceB,   ///< points of A against a line on B
};

/// The position side of one touching contact, in world axes at the start of the step.
struct OverlapConstraint
{
    b2Vec2 offset;    ///< from centre of mass A to B [m]
    b2Vec2 normal;    ///< of the face, out of its body
    b2Vec2 reference; ///< from its centre of mass to the face (or A's centre point)
    b2Vec2 points[2]; ///< from the other body's centre of mass
    float32 radius;   ///< sum of the two skins [m]
    float32 invMassA, invInertiaA, invMassB, invInertiaB;
    int32 bodyA, bodyB;
    int32 pointCount;
    OverlapKind kind;
};

/// A body whose way in a step is longer than this share of its thinnest half is fast: it could pass
/// through something, so its way is swept. Larger lets thin bodies through, smaller sweeps more
/// than need be.
inline constexpr float32 kFastShare = 0.25f;

/// Sweeps over contacts go forward and backward (symmetric Gauss-Seidel; Saad, "Iterative Methods
/// for Sparse Linear Systems", 4.1): contacts that follow the colours rather than the stack would
/// else push a tall pile to one side, sweep after sweep. This one turns after every sweep.
enum class Direction : uint8
{
    Forward,
    Backward,
};

inline Direction DirectionOf(int32 iteration)
{
    return iteration % 2 == 0 ? Direction::Forward : Direction::Backward;
}

/// The same for the velocities of coloured contacts, with as few turns as possible. Where the
/// sweeps turn, a colour is solved twice with nothing between: of two colours every other sweep
/// would be lost, and piles would be soft. So half of a step's sweeps go one way and half the
/// other, and the next step, which starts from the impulses of this one, goes on the way that this
/// one ended: `turned` in every other step.
inline Direction ColorDirectionOf(int32 iteration, int32 count, bool turned)
{
    const bool second = iteration >= (count + 1) / 2;
    return second == turned ? Direction::Forward : Direction::Backward;
}

template <class List, class Function>
void ForEach(List& list, Direction direction, Function&& function)
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

// Step.cpp

/// How far a body may move and turn at once; what is faster is slowed down.
struct MostMove
{
    float32 way;  ///< [m]
    float32 turn; ///< [rad]
};

/// In a step of the manual's scheme.
inline constexpr MostMove kMostMove = {b2_maxTranslation, b2_maxRotation};
/// In a small step: impacts are found however far a body comes and turns, and a higher limit loses
/// less energy. A box of 0.3 m that walls make tumble at 300 m/s spins with 3000 rad/s, four times
/// around in half a step at 60 Hz. With less such boxes come to rest; with much more the search for
/// an impact runs out of its steps.
inline constexpr MostMove kMostSmallMove = {10.0f * b2_maxTranslation, 40.0f * b2_maxRotation};

/// Moves and turns a body for `timeStep`, slowing it down to what it may.
void MoveByVelocity(SolverBody& body, float32 timeStep, const MostMove& most);

// ContactSolver.cpp

/// Tells the listener of the impulses that a contact's manifold, or its constraint, keeps.
void ReportImpulse(b2ContactListener& listener, b2Contact& contact);
void ReportImpulse(b2ContactListener& listener, const ContactConstraint& constraint);

/// 1 / value, or 0 for nothing to push.
inline float32 Inverse(float32 value)
{
    return value > 0.0f ? 1.0f / value : 0.0f;
}

/// Both points together: of the four ways in which each impulse or its speed can be zero, take the
/// one whose other quantities are not negative (total enumeration; Murty, "Linear Complementarity",
/// 1988). False when rounding leaves none.
bool EnumerateImpulses(float32 k11, float32 k12, float32 k22, float32 b1, float32 b2, float32& x1,
                       float32& x2);

/// Fills both sides of a touching contact from the present poses; velocities are read from the
/// bodies' solver entries (for restitution).
void PrepareContact(b2Contact& contact, const SolverContext& context, ContactConstraint& constraint,
                    OverlapConstraint& overlap);
/// Applies the impulses carried over from the last step.
void WarmStart(Array<ContactConstraint>& contacts, const SolverContext& context);
/// One iteration: friction, then the normal impulses. False when no impulse has changed: then none
/// will in the next.
bool SolveContactVelocities(std::span<ContactConstraint> contacts, SolverBody* bodies,
                            Direction direction);
/// Puts the impulses into the manifold.
void StoreImpulses(const ContactConstraint& contact);
// OverlapSolver.cpp

/// How deep a point overlaps, which way out, and where, after what has moved so far in this step.
struct Overlap
{
    b2Vec2 normal; // from A to B
    b2Vec2 armA, armB;
    float32 separation;
};

Overlap MeasureOverlap(const OverlapConstraint& o, int32 point, const SolverBody& a,
                       const SolverBody& b);

/// How far overlaps are pushed out at once: by a share of what exceeds the slop, up to `most` [m].
struct PushPace
{
    float32 rate;
    float32 most = b2_maxLinearCorrection;
};

/// How fast a body is pushed out of overlaps at most, in small steps, by all its contacts and those
/// of its island [m/s], 20 cm a frame: pushes of a row add up. With half of it stacks of 50 that
/// are put together without room for their skins come out otherwise, and free rows come apart in 1
/// s instead of 0.6.
inline constexpr float32 kFarthestPush = 12.0f;

/// How far a push has taken any point of a body at most [m].
float32 PushOf(const SolverBody& before, const SolverBody& after, float32 maxExtent);

/// Takes back all but a share of a push; its direction stays.
void ShortenPush(const SolverBody& before, SolverBody& after, float32 share);

/// One iteration of moving overlapping bodies apart. Returns the smallest separation that was met
/// [m].
float32 SolveOverlaps(std::span<const OverlapConstraint> overlaps, SolverBody* bodies,
                      PushPace pace, Direction direction);

/// Two points that are nearly one, pushed apart one after the other.
float32 SolveNearlyOnePoint(const OverlapConstraint& o, SolverBody* bodies, PushPace pace);

} // namespace box2d
