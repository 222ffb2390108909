// SPDX-License-Identifier: MIT
#pragma once

#include <Dynamics/Solver/OverlapSolver.h>
#include <Dynamics/State/Solver.h>

#include <Box2D/Common/Array.h>

#include <span>

/// The contact solver written plainly, one contact after the other: the reference of the solver in
/// lanes (Solver/ContactBlock*.h, Solver/OverlapBlockSolver.h), which gives the same bits.
/// Sequential impulses (Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005, and "Fast
/// and Simple Physics using Sequential Impulses", GDC 2006): accumulated, clamped impulses on
/// velocities, then nonlinear projection of positions.
namespace box2d
{

/// The levers are the moments about the centres of mass of a unit impulse at the point [m]: arm x
/// direction. The tangent is the normal rotated clockwise.
struct ContactPoint
{
    float32 normalLeverA, normalLeverB;
    float32 tangentLeverA, tangentLeverB;
    float32 normalImpulse;
    float32 tangentImpulse;
    float32 normalMass;  ///< effective mass
    float32 tangentMass; ///< effective mass
    float32 bias;        ///< target separation speed from restitution [m/s]
};

/// The velocity constraint of a touching contact.
struct ContactConstraint
{
    ContactPoint points[2];
    b2Vec2 normal; ///< from A to B
    float32 friction;
    float32 tangentSpeed;
    float32 invMassA, invInertiaA, invMassB, invInertiaB;
    int32 bodyA, bodyB; ///< solver index
    int32 pointCount;
    bool coupled;          ///< both points are solved together
    float32 k11, k12, k22; ///< response of the normal speeds to an impulse at either point
    b2Contact* contact;
};

/// The position constraint of a touching contact, in world axes at the start of the step.
struct OverlapConstraint
{
    b2Vec2 offset;    ///< from centre of mass A to B [m]
    b2Vec2 normal;    ///< of the face, outward
    b2Vec2 reference; ///< from its centre of mass to the face (or A's centre point)
    b2Vec2 points[2]; ///< from the other body's centre of mass
    float32 radius;   ///< sum of the two skins [m]
    float32 invMassA, invInertiaA, invMassB, invInertiaB;
    int32 bodyA, bodyB;
    int32 pointCount;
    OverlapKind kind;
};

/// Fills both constraints of a touching contact from the current poses; velocities come from the
/// bodies' solver entries (for restitution).
void PrepareContact(b2Contact& contact, const SolverContext& context, ContactConstraint& constraint,
                    OverlapConstraint& overlap);
/// Applies the impulses of the last step (warm starting).
void WarmStart(Array<ContactConstraint>& contacts, const SolverContext& context);
/// One iteration: friction, then the normal impulses. False when no impulse has changed: then none
/// will in the next.
bool SolveContactVelocities(std::span<ContactConstraint> contacts, SolverBody* bodies,
                            Direction direction);

/// One iteration of moving overlapping bodies apart. Returns the smallest separation that was met
/// [m].
float32 SolveOverlaps(std::span<const OverlapConstraint> overlaps, SolverBody* bodies,
                      PushPace pace, Direction direction);

} // namespace box2d
