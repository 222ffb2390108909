// SPDX-License-Identifier: MIT
#pragma once

#include "ContactBlockSolver.h"
#include "Restitution.h"

#include <limits>
#include <utility>

/// Computes both sides of a block from the gathered data of its contacts, for numbers F of 1, 4,
/// 8 or 16 lanes. Included like ContactBlockSolver.h, so it has no external linkage either.
namespace box2d
{
namespace
{

/// Of a body or a normal until the middle of the step; what turns faster has no contact for that
/// long [rad].
/// The sine's next term, angle^5 / 120 (SmallTurn), is 8e-6 rad then. On a lever of 10 m, the
/// largest size that the manual advises, that is 0.08 mm, a sixtieth of the slop. With 10 rad
/// large boxes lose 12 % of their energy (docs/notes/tuned-constants.md).
constexpr float32 kMaxTurn = 0.25f;

template <class F, OverlapKind kKind>
struct BlockPreparer
{
    const ContactLanes& from;
    const SolverContext& context;
    ContactBlock& block;
    OverlapBlock& overlap;
    int lane; // first lane

    static constexpr bool kFaceOnB = kKind == OverlapKind::FaceB;

    F At(const float32* field) const { return F::Load(field + lane); }
    Vector<F> At(const float32* x, const float32* y) const { return {At(x), At(y)}; }
    void Put(const Vector<F>& v, float32* x, float32* y) const
    {
        v.x.Store(x + lane);
        v.y.Store(y + lane);
    }

    /// Writes the overlap's geometry in world axes.
    void FillOverlap() const
    {
        const F sineOther = At(from.sineOther);
        const F cosineOther = At(from.cosineOther);
        const F sineFace = At(from.sineFace);
        const F cosineFace = At(from.cosineFace);
        Put(Turn(sineFace, cosineFace, At(from.normalX, from.normalY)), overlap.normalX,
            overlap.normalY);
        Put(Turn(sineFace, cosineFace, At(from.referenceX, from.referenceY)), overlap.referenceX,
            overlap.referenceY);
        for (int i = 0; i < block.pointCount; ++i)
        {
            Put(Turn(sineOther, cosineOther, At(from.pointX[i], from.pointY[i])), overlap.pointX[i],
                overlap.pointY[i]);
        }
        (At(from.radiusFace) + At(from.radiusOther)).Store(overlap.radius + lane);
    }

    /// The normal from A to B, and the points midway between the surfaces, relative to A's centre.
    struct Geometry
    {
        Vector<F> normal;
        Vector<F> points[2];
    };

    struct Bodies
    {
        F a[4], b[4]; // vx, vy, w, and the angle
        F invMassA, invInertiaA, invMassB, invInertiaB;
    };

    /// What the geometry follows from: the overlap's, at some time of the step.
    struct Places
    {
        Vector<F> offset, normal, reference;
        Vector<F> points[2];
    };

    Places PlacesAtStart() const
    {
        Places p;
        p.offset = At(overlap.offsetX, overlap.offsetY);
        p.normal = At(overlap.normalX, overlap.normalY);
        p.reference = At(overlap.referenceX, overlap.referenceY);
        for (int i = 0; i < block.pointCount; ++i)
        {
            p.points[i] = At(overlap.pointX[i], overlap.pointY[i]);
        }
        return p;
    }

    /// Returns the time to the middle of the step, or 0 for what did not press in the last step: at
    /// an impact the speeds turn, so nothing is known of the middle [s].
    F TimeToMiddle(const Places& p, const Bodies& bodies) const
    {
        F press = At(from.normalImpulse[0]);
        for (int i = 1; i < block.pointCount; ++i)
        {
            press = Max(press, At(from.normalImpulse[i]));
        }
        const auto pressed = AtLeast(press, F::Set(std::numeric_limits<float32>::min()));
        const F time = Select(pressed, F::Set(context.middle), F::Set(0.0f));
        const F spin = Max(Max(bodies.a[2], -bodies.a[2]), Max(bodies.b[2], -bodies.b[2]));
        const F slow = Min(time, F::Set(kMaxTurn) / Max(spin, F::Set(1.0f)));
        if (kKind != OverlapKind::Centers)
        {
            return slow;
        }
        // Two points turn their line, too, the faster the nearer they are.
        const Vector<F> line = p.offset + p.points[0] - p.reference;
        const Vector<F> speed = SpeedOf(bodies.b, p.points[0]) - SpeedOf(bodies.a, p.reference);
        const F most = Sqrt(F::Set(kMaxTurn * kMaxTurn) * Dot(line, line) /
                            Max(Dot(speed, speed), F::Set(std::numeric_limits<float32>::min())));
        return Min(slow, most);
    }

    /// Returns the velocity of a body's point at this arm.
    static Vector<F> SpeedOf(const F (&body)[4], const Vector<F>& arm)
    {
        return {body[0] - body[2] * arm.y, body[1] + body[2] * arm.x};
    }

    /// The sine and cosine of an angle up to the most that a contact turns.
    std::pair<F, F> SmallTurn(F angle) const
    {
        const F sine = angle - F::Set(1.0f / 6.0f) * angle * angle * angle;
        return {sine, Sqrt(F::Set(1.0f) - sine * sine)};
    }

    /// Moves the bodies on to the middle of the step, in each of their contacts alike.
    void MoveOn(Places& p, const Bodies& bodies) const
    {
        const F time = TimeToMiddle(p, bodies);
        const auto [sineA, cosineA] = SmallTurn(time * bodies.a[2]);
        const auto [sineB, cosineB] = SmallTurn(time * bodies.b[2]);
        p.offset.x = p.offset.x + time * (bodies.b[0] - bodies.a[0]);
        p.offset.y = p.offset.y + time * (bodies.b[1] - bodies.a[1]);
        const F sineFace = kFaceOnB ? sineB : sineA;
        const F cosineFace = kFaceOnB ? cosineB : cosineA;
        const F sineOther = kFaceOnB ? sineA : sineB;
        const F cosineOther = kFaceOnB ? cosineA : cosineB;
        p.normal = Turn(sineFace, cosineFace, p.normal);
        p.reference = Turn(sineFace, cosineFace, p.reference);
        for (int i = 0; i < block.pointCount; ++i)
        {
            p.points[i] = Turn(sineOther, cosineOther, p.points[i]);
        }
    }

    Geometry Measure(const Places& p) const
    {
        return kKind == OverlapKind::Centers ? MeasureCircles(p) : MeasureFace(p);
    }

    Geometry MeasureCircles(const Places& p) const
    {
        Geometry g;
        const Vector<F> onB = p.offset + p.points[0];
        g.normal = onB - p.reference;
        NormalizeOrX(g.normal);
        const Vector<F> surfaceA = p.reference + At(from.radiusFace) * g.normal;
        const Vector<F> surfaceB = onB - At(from.radiusOther) * g.normal;
        g.points[0] = F::Set(0.5f) * (surfaceA + surfaceB);
        return g;
    }

    Geometry MeasureFace(const Places& p) const
    {
        Geometry g;
        const F radiusFace = At(from.radiusFace);
        const F radiusOther = At(from.radiusOther);
        g.normal = kFaceOnB ? -p.normal : p.normal;
        const Vector<F> face = kFaceOnB ? p.offset + p.reference : p.reference;
        for (int i = 0; i < block.pointCount; ++i)
        {
            const Vector<F> core = kFaceOnB ? p.points[i] : p.offset + p.points[i];
            const F toFace = radiusFace - Dot(core - face, p.normal);
            const Vector<F> onFace = core + toFace * p.normal;
            const Vector<F> onOther = core - radiusOther * p.normal;
            g.points[i] = F::Set(0.5f) * (onFace + onOther);
        }
        return g;
    }

    void CopyImpulses(int i) const
    {
        PointLanes& p = block.points[i];
        const F ratio = F::Set(context.warmStarting ? context.stepRatio : 0.0f);
        const F share = At(from.share);
        const F zero = F::Set(0.0f);
        const F maximum = F::Set(b2_maxFloat);
        const F normal = At(from.normalImpulse[i]);
        const F tangent = At(from.tangentImpulse[i]);
        const F push = Select(AtLeast(maximum, normal), ratio * normal, zero);
        const F drag = Select(And(AtLeast(maximum, tangent), AtLeast(tangent, -maximum)),
                              ratio * tangent, zero);
        (push * share).Store(p.normalImpulse + lane);
        (drag * share).Store(p.tangentImpulse + lane);
    }

    void FillPoint(int i, const Bodies& bodies, const Vector<F>& normal, const Vector<F>& armA,
                   const Vector<F>& armB) const
    {
        PointLanes& p = block.points[i];
        const Vector<F> tangent = {normal.y, -normal.x};
        const F mass = bodies.invMassA + bodies.invMassB;
        const F nA = Cross(armA, normal);
        const F nB = Cross(armB, normal);
        const F tA = Cross(armA, tangent);
        const F tB = Cross(armB, tangent);
        nA.Store(p.normalLeverA + lane);
        nB.Store(p.normalLeverB + lane);
        tA.Store(p.tangentLeverA + lane);
        tB.Store(p.tangentLeverB + lane);
        if (block.pointCount == 1)
        {
            InverseOrZero(mass + bodies.invInertiaA * nA * nA + bodies.invInertiaB * nB * nB)
                .Store(block.pointMass[1] + lane);
        }
        InverseOrZero(mass + bodies.invInertiaA * tA * tA + bodies.invInertiaB * tB * tB)
            .Store(block.pointMass[i] + lane);
        const Vector<F> speed = {
            bodies.b[0] - bodies.b[2] * armB.y - bodies.a[0] + bodies.a[2] * armA.y,
            bodies.b[1] + bodies.b[2] * armB.x - bodies.a[1] - bodies.a[2] * armA.x};
        const F bias = BounceSpeed(Dot(speed, normal), At(from.restitution), context);
        bias.Store(block.bias[i] + lane);
        block.bounces = block.bounces || Any(Not(AtLeast(F::Set(0.0f), bias)));
    }

    void Prepare() const
    {
        const auto* bodyNumbers = reinterpret_cast<const float32*>(context.bodies);
        FillOverlap();
        Bodies bodies;
        LoadRows(bodyNumbers, kBodyStride, block.bodyA + lane, bodies.a);
        LoadRows(bodyNumbers, kBodyStride, block.bodyB + lane, bodies.b);
        bodies.invMassA = At(block.masses.invMassA);
        bodies.invInertiaA = At(block.masses.invInertiaA);
        bodies.invMassB = At(block.masses.invMassB);
        bodies.invInertiaB = At(block.masses.invInertiaB);
        Places places = PlacesAtStart();
        if (context.middle > 0.0f)
        {
            MoveOn(places, bodies);
        }
        const Geometry g = Measure(places);
        Put(g.normal, block.normalX, block.normalY);
        for (int i = 0; i < block.pointCount; ++i)
        {
            CopyImpulses(i);
            FillPoint(i, bodies, g.normal, g.points[i], g.points[i] - places.offset);
        }
        block.allCoupled = block.allCoupled && !Any(Not(AreCoupled<F>(block, lane)));
    }
};

template <class F, OverlapKind kKind>
void PrepareBlockOf(const ContactLanes& from, ContactBlock& block, OverlapBlock& overlap,
                    const SolverContext& context)
{
    block.allCoupled = block.pointCount == 2;
    block.bounces = false;
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        BlockPreparer<F, kKind>{from, context, block, overlap, lane}.Prepare();
    }
}

template <class F>
void PrepareBlock(const ContactLanes& from, ContactBlock& block, OverlapBlock& overlap,
                  const SolverContext& context)
{
    switch (overlap.kind)
    {
    case OverlapKind::FaceA:
        return PrepareBlockOf<F, OverlapKind::FaceA>(from, block, overlap, context);
    case OverlapKind::FaceB:
        return PrepareBlockOf<F, OverlapKind::FaceB>(from, block, overlap, context);
    default:
        return PrepareBlockOf<F, OverlapKind::Centers>(from, block, overlap, context);
    }
}

} // namespace
} // namespace box2d
