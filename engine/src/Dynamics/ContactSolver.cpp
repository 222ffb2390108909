// SPDX-License-Identifier: MIT
#include "Solver.h"

#include "World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

/// Contacts as constraints, by sequential impulses (Catto, "Iterative Dynamics with Temporal
/// Coherence", GDC 2005, and "Fast and Simple Physics using Sequential Impulses", GDC 2006):
/// accumulated, clamped impulses on velocities, then nonlinear projection of positions.
namespace box2d
{

namespace
{

/// A contact's geometry in world axes, as seen from the centres of mass.
struct Geometry
{
    b2Vec2 normal;    // from A to B
    b2Vec2 points[2]; // midway between the surfaces, from centre of mass A
};

Geometry MeasureCircles(const OverlapConstraint& o, float32 radiusA, float32 radiusB)
{
    Geometry g;
    const b2Vec2 onB = o.offset + o.points[0];
    g.normal = onB - o.reference;
    if (g.normal.Normalize() == 0.0f)
    {
        g.normal = b2Vec2(1.0f, 0.0f);
    }
    g.points[0] = 0.5f * ((o.reference + radiusA * g.normal) + (onB - radiusB * g.normal));
    return g;
}

Geometry MeasureFace(const OverlapConstraint& o, float32 radiusFace, float32 radiusOther)
{
    Geometry g;
    const bool faceOnA = o.kind == OverlapKind::FaceA;
    g.normal = faceOnA ? o.normal : -o.normal;
    const b2Vec2 face = faceOnA ? o.reference : o.offset + o.reference;
    for (int32 i = 0; i < o.pointCount; ++i)
    {
        const b2Vec2 core = faceOnA ? o.offset + o.points[i] : o.points[i];
        const b2Vec2 onFace = core + (radiusFace - b2Dot(core - face, o.normal)) * o.normal;
        const b2Vec2 onOther = core - radiusOther * o.normal;
        g.points[i] = 0.5f * (onFace + onOther);
    }
    return g;
}

void FillOverlap(const ContactData& c, const BodyData& a, const BodyData& b, OverlapConstraint& o)
{
    const b2Manifold& m = c.manifold;
    o.offset = CenterOffset(a, b);
    o.radius = c.fixtureA->GetShape()->m_radius + c.fixtureB->GetShape()->m_radius;
    o.bodyA = a.SolverIndex();
    o.bodyB = b.SolverIndex();
    o.invMassA = a.SolverInvMass();
    o.invInertiaA = a.SolverInvInertia();
    o.invMassB = b.SolverInvMass();
    o.invInertiaB = b.SolverInvInertia();
    o.pointCount = m.pointCount;
    const bool faceOnB = m.type == b2Manifold::e_faceB;
    const BodyData& face = faceOnB ? b : a;
    const BodyData& other = faceOnB ? a : b;
    o.kind = m.type == b2Manifold::e_circles ? OverlapKind::Centers
                                             : (faceOnB ? OverlapKind::FaceB : OverlapKind::FaceA);
    o.normal = b2Mul(face.rotation, m.localNormal);
    o.reference = b2Mul(face.rotation, m.localPoint - face.localCenter);
    for (int32 i = 0; i < m.pointCount; ++i)
    {
        o.points[i] = b2Mul(other.rotation, m.points[i].localPoint - other.localCenter);
    }
}

// The two normal constraints at once: K x + b >= 0, x >= 0, x (K x + b) = 0, with
//   K_ij = mA + mB + iA (rAi x n)(rAj x n) + iB (rBi x n)(rBj x n).
void FillCoupling(ContactConstraint& c)
{
    const ContactPoint& p1 = c.points[0];
    const ContactPoint& p2 = c.points[1];
    const float32 a1 = b2Cross(p1.armA, c.normal);
    const float32 b1 = b2Cross(p1.armB, c.normal);
    const float32 a2 = b2Cross(p2.armA, c.normal);
    const float32 b2 = b2Cross(p2.armB, c.normal);
    const float32 mass = c.invMassA + c.invMassB;
    c.k11 = mass + c.invInertiaA * a1 * a1 + c.invInertiaB * b1 * b1;
    c.k22 = mass + c.invInertiaA * a2 * a2 + c.invInertiaB * b2 * b2;
    c.k12 = mass + c.invInertiaA * a1 * a2 + c.invInertiaB * b1 * b2;
    const float32 determinant = c.k11 * c.k22 - c.k12 * c.k12;
    c.coupled = c.k11 * c.k11 < kMaxCondition * determinant;
}

void FillPoint(ContactConstraint& c, ContactPoint& p, const b2ManifoldPoint& from,
               float32 restitution, const SolverContext& context)
{
    const float32 share = context.warmStarting ? context.stepRatio : 0.0f;
    // What is not finite is forgotten.
    p.normalImpulse = from.normalImpulse <= b2_maxFloat ? share * from.normalImpulse : 0.0f;
    p.tangentImpulse =
        b2Abs(from.tangentImpulse) <= b2_maxFloat ? share * from.tangentImpulse : 0.0f;
    const b2Vec2 tangent = b2Cross(c.normal, 1.0f);
    const float32 mass = c.invMassA + c.invMassB;
    const float32 nA = b2Cross(p.armA, c.normal);
    const float32 nB = b2Cross(p.armB, c.normal);
    const float32 tA = b2Cross(p.armA, tangent);
    const float32 tB = b2Cross(p.armB, tangent);
    p.normalMass = Inverse(mass + c.invInertiaA * nA * nA + c.invInertiaB * nB * nB);
    p.tangentMass = Inverse(mass + c.invInertiaA * tA * tA + c.invInertiaB * tB * tB);
    const SolverBody& a = context.bodies[c.bodyA];
    const SolverBody& b = context.bodies[c.bodyB];
    const float32 approach =
        b2Dot(b.v + b2Cross(b.w, p.armB) - a.v - b2Cross(a.w, p.armA), c.normal);
    p.bias = approach < -b2_velocityThreshold ? -restitution * approach : 0.0f;
}

struct Velocities
{
    b2Vec2 vA, vB;
    float32 wA, wB;
};

void Apply(Velocities& v, const ContactConstraint& c, const ContactPoint& p, const b2Vec2& impulse)
{
    v.vA -= c.invMassA * impulse;
    v.wA -= c.invInertiaA * b2Cross(p.armA, impulse);
    v.vB += c.invMassB * impulse;
    v.wB += c.invInertiaB * b2Cross(p.armB, impulse);
}

/// Normal impulses at both points at once: equal ones at mirrored points leave no spin at all.
void ApplyPair(Velocities& v, const ContactConstraint& c, float32 x1, float32 x2)
{
    const ContactPoint& p1 = c.points[0];
    const ContactPoint& p2 = c.points[1];
    const b2Vec2 impulse = (x1 + x2) * c.normal;
    v.vA -= c.invMassA * impulse;
    v.wA -= c.invInertiaA * (b2Cross(p1.armA, c.normal) * x1 + b2Cross(p2.armA, c.normal) * x2);
    v.vB += c.invMassB * impulse;
    v.wB += c.invInertiaB * (b2Cross(p1.armB, c.normal) * x1 + b2Cross(p2.armB, c.normal) * x2);
}

b2Vec2 PointSpeed(const Velocities& v, const ContactPoint& p)
{
    return v.vB + b2Cross(v.wB, p.armB) - v.vA - b2Cross(v.wA, p.armA);
}

Velocities Load(const ContactConstraint& c, const SolverBody* bodies)
{
    return {bodies[c.bodyA].v, bodies[c.bodyB].v, bodies[c.bodyA].w, bodies[c.bodyB].w};
}

// What cannot be moved may be shared by several contacts of a colour: it is left alone.
void Store(const Velocities& v, const ContactConstraint& c, SolverBody* bodies)
{
    if (Moves(c.invMassA, c.invInertiaA))
    {
        bodies[c.bodyA].v = v.vA;
        bodies[c.bodyA].w = v.wA;
    }
    if (Moves(c.invMassB, c.invInertiaB))
    {
        bodies[c.bodyB].v = v.vB;
        bodies[c.bodyB].w = v.wB;
    }
}

void SolveFriction(ContactConstraint& c, Velocities& v)
{
    const b2Vec2 tangent = b2Cross(c.normal, 1.0f);
    for (int32 i = 0; i < c.pointCount; ++i)
    {
        ContactPoint& p = c.points[i];
        const float32 slip = b2Dot(PointSpeed(v, p), tangent) - c.tangentSpeed;
        const float32 limit = c.friction * p.normalImpulse;
        const float32 total = b2Clamp(p.tangentImpulse - p.tangentMass * slip, -limit, limit);
        Apply(v, c, p, (total - p.tangentImpulse) * tangent);
        p.tangentImpulse = total;
    }
}

void SolvePoint(ContactConstraint& c, ContactPoint& p, Velocities& v)
{
    const float32 speed = b2Dot(PointSpeed(v, p), c.normal);
    const float32 total = b2Max(p.normalImpulse - p.normalMass * (speed - p.bias), 0.0f);
    Apply(v, c, p, (total - p.normalImpulse) * c.normal);
    p.normalImpulse = total;
}

void SolvePair(ContactConstraint& c, Velocities& v)
{
    ContactPoint& p1 = c.points[0];
    ContactPoint& p2 = c.points[1];
    const float32 old1 = p1.normalImpulse;
    const float32 old2 = p2.normalImpulse;
    // Speeds as they would be without the impulses applied so far.
    const float32 b1 = b2Dot(PointSpeed(v, p1), c.normal) - p1.bias - (c.k11 * old1 + c.k12 * old2);
    const float32 b2 = b2Dot(PointSpeed(v, p2), c.normal) - p2.bias - (c.k12 * old1 + c.k22 * old2);
    float32 x1 = 0.0f;
    float32 x2 = 0.0f;
    if (EnumerateImpulses(c.k11, c.k12, c.k22, b1, b2, x1, x2))
    {
        ApplyPair(v, c, x1 - old1, x2 - old2);
        p1.normalImpulse = x1;
        p2.normalImpulse = x2;
    }
}

} // namespace

bool EnumerateImpulses(float32 k11, float32 k12, float32 k22, float32 b1, float32 b2, float32& x1,
                       float32& x2)
{
    const float32 inverse = 1.0f / (k11 * k22 - k12 * k12);
    x1 = inverse * (k12 * b2 - k22 * b1);
    x2 = inverse * (k12 * b1 - k11 * b2);
    if (x1 >= 0.0f && x2 >= 0.0f)
    {
        return true;
    }
    x1 = -b1 / k11;
    x2 = 0.0f;
    if (x1 >= 0.0f && k12 * x1 + b2 >= 0.0f)
    {
        return true;
    }
    x1 = 0.0f;
    x2 = -b2 / k22;
    if (x2 >= 0.0f && k12 * x2 + b1 >= 0.0f)
    {
        return true;
    }
    x2 = 0.0f;
    return b1 >= 0.0f && b2 >= 0.0f;
}

void PrepareContact(b2Contact& contact, const SolverContext& context, ContactConstraint& c,
                    OverlapConstraint& o)
{
    const ContactData& data = Data(contact);
    const BodyData& a = Data(*data.bodyA);
    const BodyData& b = Data(*data.bodyB);
    FillOverlap(data, a, b, o);
    c.contact = &contact;
    c.friction = data.friction;
    c.tangentSpeed = data.tangentSpeed;
    c.invMassA = o.invMassA;
    c.invInertiaA = o.invInertiaA;
    c.invMassB = o.invMassB;
    c.invInertiaB = o.invInertiaB;
    c.bodyA = o.bodyA;
    c.bodyB = o.bodyB;
    c.pointCount = o.pointCount;
    const float32 radiusA = data.fixtureA->GetShape()->m_radius;
    const float32 radiusB = data.fixtureB->GetShape()->m_radius;
    const Geometry g = o.kind == OverlapKind::Centers ? MeasureCircles(o, radiusA, radiusB)
                       : o.kind == OverlapKind::FaceA ? MeasureFace(o, radiusA, radiusB)
                                                      : MeasureFace(o, radiusB, radiusA);
    c.normal = g.normal;
    for (int32 i = 0; i < c.pointCount; ++i)
    {
        c.points[i].armA = g.points[i];
        c.points[i].armB = g.points[i] - o.offset;
        FillPoint(c, c.points[i], data.manifold.points[i], data.restitution, context);
    }
    c.coupled = false;
    if (c.pointCount == 2)
    {
        FillCoupling(c);
    }
}

void WarmStart(Array<ContactConstraint>& contacts, const SolverContext& context)
{
    for (ContactConstraint& c : contacts)
    {
        const b2Vec2 tangent = b2Cross(c.normal, 1.0f);
        Velocities v = Load(c, context.bodies);
        for (int32 i = 0; i < c.pointCount; ++i)
        {
            const ContactPoint& p = c.points[i];
            Apply(v, c, p, p.normalImpulse * c.normal + p.tangentImpulse * tangent);
        }
        Store(v, c, context.bodies);
    }
}

namespace
{

b2Vec2 ImpulseAt(const ContactConstraint& c, int32 point)
{
    return point < c.pointCount
               ? b2Vec2(c.points[point].normalImpulse, c.points[point].tangentImpulse)
               : b2Vec2(0.0f, 0.0f);
}

} // namespace

bool SolveContactVelocities(Array<ContactConstraint>& contacts, SolverBody* bodies,
                            Direction direction)
{
    bool changed = false;
    ForEach(contacts, direction, [bodies, &changed](ContactConstraint& c) {
        const b2Vec2 before[2] = {ImpulseAt(c, 0), ImpulseAt(c, 1)};
        Velocities v = Load(c, bodies);
        SolveFriction(c, v);
        if (c.coupled)
        {
            SolvePair(c, v);
        }
        else
        {
            for (int32 i = 0; i < c.pointCount; ++i)
            {
                SolvePoint(c, c.points[i], v);
            }
        }
        Store(v, c, bodies);
        changed = changed || ImpulseAt(c, 0) != before[0] || ImpulseAt(c, 1) != before[1];
    });
    return changed;
}

namespace
{

template <class Points>
b2ContactImpulse ImpulseOf(const Points& points, int32 count)
{
    b2ContactImpulse impulse;
    impulse.count = count;
    for (int32 i = 0; i < count; ++i)
    {
        impulse.normalImpulses[i] = points[i].normalImpulse;
        impulse.tangentImpulses[i] = points[i].tangentImpulse;
    }
    return impulse;
}

} // namespace

void ReportImpulse(b2ContactListener& listener, b2Contact& contact)
{
    const b2Manifold& manifold = Data(contact).manifold;
    const b2ContactImpulse impulse = ImpulseOf(manifold.points, manifold.pointCount);
    listener.PostSolve(&contact, &impulse);
}

void ReportImpulse(b2ContactListener& listener, const ContactConstraint& constraint)
{
    const b2ContactImpulse impulse = ImpulseOf(constraint.points, constraint.pointCount);
    listener.PostSolve(constraint.contact, &impulse);
}

void StoreImpulses(const ContactConstraint& c)
{
    b2Manifold& m = Data(*c.contact).manifold;
    for (int32 i = 0; i < c.pointCount; ++i)
    {
        m.points[i].normalImpulse = c.points[i].normalImpulse;
        m.points[i].tangentImpulse = c.points[i].tangentImpulse;
    }
}

} // namespace box2d
