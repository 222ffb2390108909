// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"
#include "OverlapSolver.h"

/// The push of one contact at a time, where two points are nearly one. OverlapBlockSolver.h pushes
/// all others.
namespace box2d
{

/// Returns how far a point is pushed out [m]; negative if there is a gap. A slop remains, so that
/// the contact lasts.
inline float32 PushOut(const Overlap& overlap, PushPace pace)
{
    return b2Clamp(-pace.rate * (overlap.separation + b2_linearSlop), -pace.maximum, pace.maximum);
}

/// The bodies of one contact: load, push, store.
struct Push
{
    const OverlapConstraint& o;
    SolverBody a, b;

    void Store(SolverBody* bodies) const
    {
        if (Moves(o.invMassA, o.invInertiaA))
        {
            bodies[o.bodyA] = a;
        }
        if (Moves(o.invMassB, o.invInertiaB))
        {
            bodies[o.bodyB] = b;
        }
    }

    /// A body that cannot rotate keeps its bits with any number of contacts.
    static void Turn(SolverBody& body, float32 invInertia, float32 delta)
    {
        if (invInertia > 0.0f)
        {
            body.Rotate(delta);
        }
    }
    float32 Mass(const Overlap& p, const Overlap& q) const
    {
        return o.invMassA + o.invMassB +
               o.invInertiaA * b2Cross(p.armA, p.normal) * b2Cross(q.armA, q.normal) +
               o.invInertiaB * b2Cross(p.armB, p.normal) * b2Cross(q.armB, q.normal);
    }
    void Apply(const Overlap& p, float32 impulse)
    {
        a.d -= (o.invMassA * impulse) * p.normal;
        b.d += (o.invMassB * impulse) * p.normal;
        Turn(a, o.invInertiaA, -o.invInertiaA * b2Cross(p.armA, p.normal) * impulse);
        Turn(b, o.invInertiaB, o.invInertiaB * b2Cross(p.armB, p.normal) * impulse);
    }
};

inline float32 PushPoint(Push& push, int32 point, PushPace pace)
{
    const Overlap overlap = MeasureOverlap(push.o, point, push.a, push.b);
    const float32 out = PushOut(overlap, pace);
    if (out > 0.0f)
    {
        push.Apply(overlap, out * Inverse(push.Mass(overlap, overlap)));
    }
    return overlap.separation;
}

} // namespace box2d
