// SPDX-License-Identifier: MIT
#include "../State/Solver.h"

/// Overlaps by nonlinear projection of positions (Catto, GDC 2006): contacts are measured again
/// before each push. The scalar version, for impacts and as the reference of OverlapBlockSolver.h.
namespace box2d
{

Overlap MeasureOverlap(const OverlapConstraint& o, int32 point, const SolverBody& a,
                       const SolverBody& b)
{
    Overlap result;
    const bool faceOnB = o.kind == OverlapKind::FaceB;
    const b2Vec2 offset = o.offset + b.d - a.d; // between the centres of mass
    const b2Vec2 reference = b2Mul(faceOnB ? b.q : a.q, o.reference);
    const b2Vec2 other = b2Mul(faceOnB ? a.q : b.q, o.points[point]);
    if (o.kind == OverlapKind::Centers)
    {
        const b2Vec2 onB = offset + other;
        result.normal = onB - reference;
        const float32 distance = result.normal.Normalize();
        result.normal = distance == 0.0f ? b2Vec2(1.0f, 0.0f) : result.normal;
        result.separation = distance - o.radius;
        result.armA = 0.5f * (reference + onB);
        result.armB = result.armA - offset;
        return result;
    }
    const b2Vec2 normal = b2Mul(faceOnB ? b.q : a.q, o.normal);
    if (faceOnB)
    {
        result.separation = b2Dot(other - (offset + reference), normal) - o.radius;
        result.armA = other;
        result.armB = other - offset;
        result.normal = -normal;
    }
    else
    {
        result.separation = b2Dot(offset + other - reference, normal) - o.radius;
        result.armA = offset + other;
        result.armB = other;
        result.normal = normal;
    }
    return result;
}

namespace
{

/// Returns how far a point is pushed out [m]; negative if there is a gap. A slop remains, so that
/// the contact lasts.
float32 PushOut(const Overlap& overlap, PushPace pace)
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
    /// Both points together, as for velocities, so that a box that lands flat stays flat.
    void ApplyPair(const Overlap& p, float32 x1, const Overlap& q, float32 x2)
    {
        const float32 sum = x1 + x2;
        a.d -= (o.invMassA * sum) * p.normal;
        b.d += (o.invMassB * sum) * p.normal;
        Turn(a, o.invInertiaA,
             -o.invInertiaA * (b2Cross(p.armA, p.normal) * x1 + b2Cross(q.armA, q.normal) * x2));
        Turn(b, o.invInertiaB,
             o.invInertiaB * (b2Cross(p.armB, p.normal) * x1 + b2Cross(q.armB, q.normal) * x2));
    }
};

float32 PushPoint(Push& push, int32 point, PushPace pace)
{
    const Overlap overlap = MeasureOverlap(push.o, point, push.a, push.b);
    const float32 out = PushOut(overlap, pace);
    if (out > 0.0f)
    {
        push.Apply(overlap, out * Inverse(push.Mass(overlap, overlap)));
    }
    return overlap.separation;
}

float32 PushPair(Push& push, PushPace pace)
{
    const Overlap p = MeasureOverlap(push.o, 0, push.a, push.b);
    const Overlap q = MeasureOverlap(push.o, 1, push.a, push.b);
    const float32 smaller = b2Min(p.separation, q.separation);
    const float32 outP = PushOut(p, pace);
    const float32 outQ = PushOut(q, pace);
    if (outP <= 0.0f && outQ <= 0.0f)
    {
        return smaller;
    }
    const float32 k11 = push.Mass(p, p);
    const float32 k12 = push.Mass(p, q);
    const float32 k22 = push.Mass(q, q);
    float32 x1 = 0.0f;
    float32 x2 = 0.0f;
    if (k11 * k11 < kMaxCondition * (k11 * k22 - k12 * k12))
    {
        if (EnumerateImpulses(k11, k12, k22, -outP, -outQ, x1, x2))
        {
            push.ApplyPair(p, x1, q, x2);
        }
        return smaller;
    }
    // Separate statements: the evaluation order of arguments is unspecified.
    const float32 first = PushPoint(push, 0, pace);
    const float32 second = PushPoint(push, 1, pace);
    return b2Min(first, second);
}

} // namespace

float32 PushOf(const SolverBody& before, const SolverBody& after, float32 maxExtent)
{
    return (after.d - before.d).Length() + b2Abs(after.angle - before.angle) * maxExtent;
}

void ShortenPush(const SolverBody& before, SolverBody& after, float32 share)
{
    const float32 turn = after.angle - before.angle;
    after.d = before.d + share * (after.d - before.d);
    after.q = before.q;
    after.angle = before.angle;
    if (turn != 0.0f)
    {
        after.Rotate(share * turn);
    }
}

float32 SolveNearlyOnePoint(const OverlapConstraint& o, SolverBody* bodies, PushPace pace)
{
    Push push{o, bodies[o.bodyA], bodies[o.bodyB]};
    const float32 first = PushPoint(push, 0, pace);
    const float32 second = PushPoint(push, 1, pace);
    push.Store(bodies);
    return b2Min(first, second);
}

float32 SolveOverlaps(std::span<const OverlapConstraint> overlaps, SolverBody* bodies,
                      PushPace pace, Direction direction)
{
    float32 smallest = 0.0f;
    ForEach(overlaps, direction, [&](const OverlapConstraint& o) {
        Push push{o, bodies[o.bodyA], bodies[o.bodyB]};
        const float32 separation =
            o.pointCount == 2 ? PushPair(push, pace) : PushPoint(push, 0, pace);
        smallest = b2Min(smallest, separation);
        push.Store(bodies);
    });
    return smallest;
}

} // namespace box2d
