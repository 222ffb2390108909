// SPDX-License-Identifier: MIT
#pragma once

#include "ContactBlockSolver.h"
#include "OverlapSolver.h"

/// The position solver on blocks, for numbers F of 1, 4, 8 or 16 lanes: contacts are measured again
/// before each push. Included like ContactBlockSolver.h, so it has no external linkage either.
namespace box2d
{
namespace
{

template <class F>
struct OverlapLanes
{
    Vector<F> normal; // from A to B
    Vector<F> armA, armB;
    F separation;
};

/// Measures one point of each lane. Bodies are moved by (0, 1) and rotated by sine 2 and cosine 3.
template <OverlapKind kKind, class F>
OverlapLanes<F> Measure(const OverlapBlock& block, int lane, int point, const F (&a)[4],
                        const F (&b)[4])
{
    constexpr bool faceOnB = kKind == OverlapKind::FaceB;
    const auto at = [lane](const float32* x, const float32* y) {
        return Vector<F>{F::Load(x + lane), F::Load(y + lane)};
    };
    const auto turn = [](const F(&body)[4], const Vector<F>& v) {
        return Turn(body[2], body[3], v);
    };
    OverlapLanes<F> result;
    const Vector<F> offset =
        at(block.offsetX, block.offsetY) + Vector<F>{b[0], b[1]} - Vector<F>{a[0], a[1]};
    const Vector<F> reference = turn(faceOnB ? b : a, at(block.referenceX, block.referenceY));
    const Vector<F> other = turn(faceOnB ? a : b, at(block.pointX[point], block.pointY[point]));
    const F radius = F::Load(block.radius + lane);
    if constexpr (kKind == OverlapKind::Centers)
    {
        const Vector<F> onB = offset + other;
        result.normal = onB - reference;
        result.separation = NormalizeOrX(result.normal) - radius;
        result.armA = F::Set(0.5f) * (reference + onB);
        result.armB = result.armA - offset;
        return result;
    }
    const Vector<F> normal = turn(faceOnB ? b : a, at(block.normalX, block.normalY));
    const Vector<F> face = faceOnB ? offset + reference : reference;
    result.armA = faceOnB ? other : offset + other;
    result.armB = faceOnB ? other - offset : other;
    result.separation = Dot(result.armA - face, normal) - radius;
    result.normal = faceOnB ? -normal : normal;
    return result;
}

template <class F>
struct OverlapSolver
{
    const OverlapBlock& block;
    const MassLanes& masses;
    int lane;           // first lane
    F a[4], b[4];       // moved by (0, 1), rotated by sine 2 and cosine 3
    F turnedA, turnedB; // total rotation by this block [rad]
    bool moved = false;

    OverlapSolver(const OverlapBlock& from, const MassLanes& massesOf, int first,
                  const float32* bodies)
        : block(from), masses(massesOf), lane(first)
    {
        // Loads the last four of a body's eight numbers.
        LoadRows(bodies + 4, kBodyStride, block.bodyA + lane, a);
        LoadRows(bodies + 4, kBodyStride, block.bodyB + lane, b);
        turnedA = turnedB = F::Set(0.0f);
    }

    void Store(float32* bodies) const
    {
        if (!moved)
        {
            return;
        }
        StoreSide(bodies, block.bodyA + lane, uint32(block.movesA) >> lane, a, turnedA);
        StoreSide(bodies, block.bodyB + lane, uint32(block.movesB) >> lane, b, turnedB);
    }

    static void StoreSide(float32* bodies, const int32* indices, uint32 moves, const F (&rows)[4],
                          F turned)
    {
        StoreMoved(bodies + 4, indices, moves, rows);
        float32 angles[F::kLanes];
        turned.Store(angles);
        for (int i = 0; i < F::kLanes; ++i)
        {
            if ((moves >> i & 1u) != 0)
            {
                bodies[kBodyStride * indices[i] + 3] += angles[i];
            }
        }
    }

    F At(const float32* field) const { return F::Load(field + lane); }

    template <OverlapKind kKind>
    OverlapLanes<F> MeasurePoint(int point) const
    {
        return Measure<kKind>(block, lane, point, a, b);
    }

    static F PushOut(const OverlapLanes<F>& overlap, PushPace pace)
    {
        const F maximum = F::Set(pace.maximum);
        const F out = F::Set(-pace.rate) * (overlap.separation + F::Set(b2_linearSlop));
        return Max(-maximum, Min(out, maximum));
    }

    F Mass(const OverlapLanes<F>& p, const OverlapLanes<F>& q) const
    {
        return At(masses.invMassA) + At(masses.invMassB) +
               At(masses.invInertiaA) * Cross(p.armA, p.normal) * Cross(q.armA, q.normal) +
               At(masses.invInertiaB) * Cross(p.armB, p.normal) * Cross(q.armB, q.normal);
    }

    /// Lanes that are not `active`, or whose body cannot rotate, are unchanged.
    template <class M>
    static void Rotate(F (&body)[4], F& turned, F invInertia, M active, F delta)
    {
        const F zero = F::Set(0.0f);
        const F s = body[2] + delta * body[3];
        const F c = body[3] - delta * body[2];
        const F inverseLength = F::Set(1.0f) / Sqrt(s * s + c * c);
        const auto fixed = AtLeast(zero, invInertia);
        body[2] = Select(active, Select(fixed, body[2], s * inverseLength), body[2]);
        body[3] = Select(active, Select(fixed, body[3], c * inverseLength), body[3]);
        turned = turned + Select(active, Select(fixed, zero, delta), zero);
    }

    template <class M>
    void Move(M active, const Vector<F>& normal, F impulse, F turnA, F turnB)
    {
        moved = true;
        const F alongA = At(masses.invMassA) * impulse;
        const F alongB = At(masses.invMassB) * impulse;
        a[0] = Select(active, a[0] - alongA * normal.x, a[0]);
        a[1] = Select(active, a[1] - alongA * normal.y, a[1]);
        b[0] = Select(active, b[0] + alongB * normal.x, b[0]);
        b[1] = Select(active, b[1] + alongB * normal.y, b[1]);
        Rotate(a, turnedA, At(masses.invInertiaA), active, turnA);
        Rotate(b, turnedB, At(masses.invInertiaB), active, turnB);
    }

    /// Returns the separation before the push.
    template <OverlapKind kKind>
    F PushPoint(int point, PushPace pace)
    {
        const OverlapLanes<F> p = MeasurePoint<kKind>(point);
        const F out = PushOut(p, pace);
        const auto idle = AtLeast(F::Set(0.0f), out);
        const F impulse = out * InverseOrZero(Mass(p, p));
        Move(Not(idle), p.normal, impulse,
             -At(masses.invInertiaA) * Cross(p.armA, p.normal) * impulse,
             At(masses.invInertiaB) * Cross(p.armB, p.normal) * impulse);
        return p.separation;
    }

    /// Both points together. `nearlyOne` is set in the lanes that must be solved point by point.
    template <OverlapKind kKind>
    F PushPair(PushPace pace, F& nearlyOne)
    {
        const F zero = F::Set(0.0f);
        const F one = F::Set(1.0f);
        const OverlapLanes<F> p = MeasurePoint<kKind>(0);
        const OverlapLanes<F> q = MeasurePoint<kKind>(1);
        const F outP = PushOut(p, pace);
        const F outQ = PushOut(q, pace);
        const auto active = Not(And(AtLeast(zero, outP), AtLeast(zero, outQ)));
        nearlyOne = zero;
        if (!Any(active))
        {
            return Min(p.separation, q.separation);
        }
        const PairResponse<F> k = {Mass(p, p), Mass(p, q), Mass(q, q)};
        const auto single = AtLeast(k.k11 * k.k11, F::Set(kMaxCondition) * k.Determinant());
        nearlyOne = Select(And(active, single), one, zero);
        F x1, x2;
        const auto solved = k.Enumerate(-outP, -outQ, x1, x2);
        const auto pushed = And(And(active, Not(single)), solved);
        const F turnA = Cross(p.armA, p.normal) * x1 + Cross(q.armA, q.normal) * x2;
        const F turnB = Cross(p.armB, p.normal) * x1 + Cross(q.armB, q.normal) * x2;
        Move(pushed, p.normal, x1 + x2, -At(masses.invInertiaA) * turnA,
             At(masses.invInertiaB) * turnB);
        return Min(p.separation, q.separation);
    }
};

/// Returns the minimum of the numbers and zero.
template <class F>
float32 SmallestOf(F numbers, float32 smallest)
{
    float32 lanes[F::kLanes];
    numbers.Store(lanes);
    for (const float32 number : lanes)
    {
        smallest = number < smallest ? number : smallest;
    }
    return smallest;
}

/// Solves two nearly coincident points of a lane one after the other.
template <OverlapKind kKind>
float32 SolveNearlyOnePoint(const OverlapBlock& block, const MassLanes& masses, int lane,
                            float32* bodies, PushPace pace)
{
    float32 smallest = 0.0f;
    for (int point = 0; point < 2; ++point)
    {
        OverlapSolver<simd::Float1> solver(block, masses, lane, bodies);
        smallest = SmallestOf(solver.PushPoint<kKind>(point, pace), smallest);
        solver.Store(bodies);
    }
    return smallest;
}

template <class F, OverlapKind kKind>
float32 SolveOverlapPairs(const OverlapBlock& block, const MassLanes& masses, float32* bodies,
                          PushPace pace)
{
    float32 smallest = 0.0f;
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        OverlapSolver<F> solver(block, masses, lane, bodies);
        F nearlyOne;
        F separation = solver.template PushPair<kKind>(pace, nearlyOne);
        const auto alone = AtLeast(nearlyOne, F::Set(1.0f));
        solver.Store(bodies);
        if (Any(alone))
        {
            separation = Select(alone, F::Set(0.0f), separation);
            float32 lanes[F::kLanes];
            nearlyOne.Store(lanes);
            for (int i = 0; i < F::kLanes; ++i)
            {
                if (lanes[i] == 1.0f)
                {
                    smallest = b2Min(smallest, SolveNearlyOnePoint<kKind>(block, masses, lane + i,
                                                                          bodies, pace));
                }
            }
        }
        smallest = SmallestOf(separation, smallest);
    }
    return smallest;
}

template <class F, OverlapKind kKind>
float32 SolveOverlapPoints(const OverlapBlock& block, const MassLanes& masses, float32* bodies,
                           PushPace pace)
{
    float32 smallest = 0.0f;
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        OverlapSolver<F> solver(block, masses, lane, bodies);
        smallest = SmallestOf(solver.template PushPoint<kKind>(0, pace), smallest);
        solver.Store(bodies);
    }
    return smallest;
}

template <class F>
float32 SolveOverlapBlock(const OverlapBlock& block, const MassLanes& masses, float32* bodies,
                          PushPace pace)
{
    const bool pair = block.pointCount == 2;
    switch (block.kind)
    {
    case OverlapKind::FaceA:
        return pair ? SolveOverlapPairs<F, OverlapKind::FaceA>(block, masses, bodies, pace)
                    : SolveOverlapPoints<F, OverlapKind::FaceA>(block, masses, bodies, pace);
    case OverlapKind::FaceB:
        return pair ? SolveOverlapPairs<F, OverlapKind::FaceB>(block, masses, bodies, pace)
                    : SolveOverlapPoints<F, OverlapKind::FaceB>(block, masses, bodies, pace);
    default:
        return SolveOverlapPoints<F, OverlapKind::Centers>(block, masses, bodies, pace);
    }
}

} // namespace
} // namespace box2d
