// SPDX-License-Identifier: MIT
#include "OverlapSolver.h"
#include "OverlapPush.h"

/// Overlaps by nonlinear projection of positions (Catto, GDC 2006): contacts are measured again
/// before each push.
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

} // namespace box2d
