// SPDX-License-Identifier: MIT
#include "ReferenceContacts.h"
#include <Dynamics/Solver/OverlapSolver.h>

#include <Dynamics/Solver/Restitution.h>
#include <Dynamics/State/World.h>

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

namespace box2d
{

namespace
{

/// A contact's geometry in world axes, relative to the centres of mass.
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
    o.radius = c.FixtureA()->GetShape()->m_radius + c.FixtureB()->GetShape()->m_radius;
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

// Solves two normal constraints together: K x + b >= 0, x >= 0, x (K x + b) = 0, with
//   K_ij = mA + mB + iA (rAi x n)(rAj x n) + iB (rBi x n)(rBj x n).
void FillCoupling(ContactConstraint& c)
{
    const ContactPoint& p1 = c.points[0];
    const ContactPoint& p2 = c.points[1];
    const float32 a1 = p1.normalLeverA;
    const float32 b1 = p1.normalLeverB;
    const float32 a2 = p2.normalLeverA;
    const float32 b2 = p2.normalLeverB;
    const float32 mass = c.invMassA + c.invMassB;
    c.k11 = mass + c.invInertiaA * a1 * a1 + c.invInertiaB * b1 * b1;
    c.k22 = mass + c.invInertiaA * a2 * a2 + c.invInertiaB * b2 * b2;
    c.k12 = mass + c.invInertiaA * a1 * a2 + c.invInertiaB * b1 * b2;
    const float32 determinant = c.k11 * c.k22 - c.k12 * c.k12;
    c.coupled = c.k11 * c.k11 < kMaxCondition * determinant;
}

void FillPoint(ContactConstraint& c, ContactPoint& p, const b2Vec2& armA, const b2Vec2& armB,
               const b2ManifoldPoint& from, float32 restitution, const SolverContext& context)
{
    const float32 share = context.warmStarting ? context.stepRatio : 0.0f;
    // Impulses that are not finite are reset.
    p.normalImpulse = from.normalImpulse <= b2_maxFloat ? share * from.normalImpulse : 0.0f;
    p.tangentImpulse =
        b2Abs(from.tangentImpulse) <= b2_maxFloat ? share * from.tangentImpulse : 0.0f;
    const b2Vec2 tangent = b2Cross(c.normal, 1.0f);
    const float32 mass = c.invMassA + c.invMassB;
    const float32 nA = b2Cross(armA, c.normal);
    const float32 nB = b2Cross(armB, c.normal);
    const float32 tA = b2Cross(armA, tangent);
    const float32 tB = b2Cross(armB, tangent);
    p.normalLeverA = nA;
    p.normalLeverB = nB;
    p.tangentLeverA = tA;
    p.tangentLeverB = tB;
    p.normalMass = box2d::InverseOrZero(mass + c.invInertiaA * nA * nA + c.invInertiaB * nB * nB);
    p.tangentMass = box2d::InverseOrZero(mass + c.invInertiaA * tA * tA + c.invInertiaB * tB * tB);
    const SolverBody& a = context.bodies[c.bodyA];
    const SolverBody& b = context.bodies[c.bodyB];
    const float32 speed = b2Dot(b.v + b2Cross(b.w, armB) - a.v - b2Cross(a.w, armA), c.normal);
    p.bias = BounceSpeed(simd::Float1{speed}, simd::Float1{restitution}, context).v;
}

/// The motion of a contact's bodies along its normal and tangent. Only the difference of the centre
/// velocities matters. The change of each velocity is computed once, from the sums of impulses.
struct Motion
{
    float32 along, across;            // velocity of centre B relative to A [m/s]
    float32 wA, wB;                   // [rad/s]
    float32 push = 0.0f, drag = 0.0f; // impulses applied along the normal and the tangent [Ns]
    float32 invMass;                  // sum of both bodies
};

Motion Load(const ContactConstraint& c, const SolverBody* bodies)
{
    const SolverBody& a = bodies[c.bodyA];
    const SolverBody& b = bodies[c.bodyB];
    const b2Vec2 apart = b.v - a.v;
    Motion m;
    m.along = apart.x * c.normal.x + apart.y * c.normal.y;
    m.across = apart.x * c.normal.y - apart.y * c.normal.x;
    m.wA = a.w;
    m.wB = b.w;
    m.invMass = c.invMassA + c.invMassB;
    return m;
}

// A body with infinite mass may be shared by several contacts of a colour: it is not written.
void Store(const Motion& m, const ContactConstraint& c, SolverBody* bodies)
{
    const b2Vec2 impulse(m.push * c.normal.x + m.drag * c.normal.y,
                         m.push * c.normal.y - m.drag * c.normal.x);
    if (Moves(c.invMassA, c.invInertiaA))
    {
        bodies[c.bodyA].v -= c.invMassA * impulse;
        bodies[c.bodyA].w = m.wA;
    }
    if (Moves(c.invMassB, c.invInertiaB))
    {
        bodies[c.bodyB].v += c.invMassB * impulse;
        bodies[c.bodyB].w = m.wB;
    }
}

void SolveFriction(ContactConstraint& c, Motion& m)
{
    for (int32 i = 0; i < c.pointCount; ++i)
    {
        ContactPoint& p = c.points[i];
        const float32 slip =
            m.across + m.wB * p.tangentLeverB - m.wA * p.tangentLeverA - c.tangentSpeed;
        const float32 limit = c.friction * p.normalImpulse;
        const float32 total = b2Clamp(p.tangentImpulse - p.tangentMass * slip, -limit, limit);
        const float32 change = total - p.tangentImpulse;
        m.across += m.invMass * change;
        m.wA -= c.invInertiaA * p.tangentLeverA * change;
        m.wB += c.invInertiaB * p.tangentLeverB * change;
        m.drag += change;
        p.tangentImpulse = total;
    }
}

float32 NormalSpeed(const Motion& m, const ContactPoint& p)
{
    return m.along + m.wB * p.normalLeverB - m.wA * p.normalLeverA;
}

void SolvePoint(ContactConstraint& c, ContactPoint& p, Motion& m)
{
    const float32 speed = NormalSpeed(m, p);
    const float32 total = b2Max(p.normalImpulse - p.normalMass * (speed - p.bias), 0.0f);
    const float32 change = total - p.normalImpulse;
    m.along += m.invMass * change;
    m.wA -= c.invInertiaA * p.normalLeverA * change;
    m.wB += c.invInertiaB * p.normalLeverB * change;
    m.push += change;
    p.normalImpulse = total;
}

/// Solves both points together. Of the four cases in which each impulse or its speed is zero,
/// selects the one with no negative value (total enumeration; Murty, "Linear Complementarity",
/// 1988). False if rounding leaves none.
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

void SolvePair(ContactConstraint& c, Motion& m)
{
    ContactPoint& p1 = c.points[0];
    ContactPoint& p2 = c.points[1];
    const float32 old1 = p1.normalImpulse;
    const float32 old2 = p2.normalImpulse;
    // Speeds without the impulses applied so far.
    const float32 b1 = NormalSpeed(m, p1) - p1.bias - (c.k11 * old1 + c.k12 * old2);
    const float32 b2 = NormalSpeed(m, p2) - p2.bias - (c.k12 * old1 + c.k22 * old2);
    float32 x1 = 0.0f;
    float32 x2 = 0.0f;
    if (EnumerateImpulses(c.k11, c.k12, c.k22, b1, b2, x1, x2))
    {
        // Both together: equal impulses at mirrored points cause exactly no rotation.
        const float32 change1 = x1 - old1;
        const float32 change2 = x2 - old2;
        m.wA -= c.invInertiaA * (p1.normalLeverA * change1 + p2.normalLeverA * change2);
        m.wB += c.invInertiaB * (p1.normalLeverB * change1 + p2.normalLeverB * change2);
        m.push += change1 + change2;
        p1.normalImpulse = x1;
        p2.normalImpulse = x2;
    }
}

} // namespace

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
    const float32 radiusA = data.FixtureA()->GetShape()->m_radius;
    const float32 radiusB = data.FixtureB()->GetShape()->m_radius;
    const Geometry g = o.kind == OverlapKind::Centers ? MeasureCircles(o, radiusA, radiusB)
                       : o.kind == OverlapKind::FaceA ? MeasureFace(o, radiusA, radiusB)
                                                      : MeasureFace(o, radiusB, radiusA);
    c.normal = g.normal;
    for (int32 i = 0; i < c.pointCount; ++i)
    {
        FillPoint(c, c.points[i], g.points[i], g.points[i] - o.offset, data.manifold.points[i],
                  data.restitution, context);
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
        Motion m = Load(c, context.bodies);
        for (int32 i = 0; i < c.pointCount; ++i)
        {
            const ContactPoint& p = c.points[i];
            m.wA -= c.invInertiaA *
                    (p.normalLeverA * p.normalImpulse + p.tangentLeverA * p.tangentImpulse);
            m.wB += c.invInertiaB *
                    (p.normalLeverB * p.normalImpulse + p.tangentLeverB * p.tangentImpulse);
            m.push += p.normalImpulse;
            m.drag += p.tangentImpulse;
        }
        Store(m, c, context.bodies);
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

bool SolveContactVelocities(std::span<ContactConstraint> contacts, SolverBody* bodies,
                            Direction direction)
{
    bool changed = false;
    ForEach(contacts, direction, [bodies, &changed](ContactConstraint& c) {
        const b2Vec2 before[2] = {ImpulseAt(c, 0), ImpulseAt(c, 1)};
        Motion m = Load(c, bodies);
        SolveFriction(c, m);
        if (c.coupled)
        {
            SolvePair(c, m);
        }
        else
        {
            for (int32 i = 0; i < c.pointCount; ++i)
            {
                SolvePoint(c, c.points[i], m);
            }
        }
        Store(m, c, bodies);
        changed = changed || ImpulseAt(c, 0) != before[0] || ImpulseAt(c, 1) != before[1];
    });
    return changed;
}

namespace
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
};

float32 PushPoint(Push& push, int32 point, PushPace pace)
{
    const Overlap overlap = MeasureOverlap(push.o, point, push.a, push.b);
    const float32 out = PushOut(overlap, pace);
    if (out > 0.0f)
    {
        push.Apply(overlap, out * box2d::InverseOrZero(push.Mass(overlap, overlap)));
    }
    return overlap.separation;
}

/// Both points together, as for velocities, so that a box that lands flat stays flat.
void ApplyPair(Push& push, const Overlap& p, float32 x1, const Overlap& q, float32 x2)
{
    const float32 sum = x1 + x2;
    push.a.d -= (push.o.invMassA * sum) * p.normal;
    push.b.d += (push.o.invMassB * sum) * p.normal;
    Push::Turn(push.a, push.o.invInertiaA,
               -push.o.invInertiaA *
                   (b2Cross(p.armA, p.normal) * x1 + b2Cross(q.armA, q.normal) * x2));
    Push::Turn(push.b, push.o.invInertiaB,
               push.o.invInertiaB *
                   (b2Cross(p.armB, p.normal) * x1 + b2Cross(q.armB, q.normal) * x2));
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
            ApplyPair(push, p, x1, q, x2);
        }
        return smaller;
    }
    // Separate statements: the evaluation order of arguments is unspecified.
    const float32 first = PushPoint(push, 0, pace);
    const float32 second = PushPoint(push, 1, pace);
    return b2Min(first, second);
}

} // namespace

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
