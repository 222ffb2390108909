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

    static Vector<F> Add(const Vector<F>& u, const Vector<F>& v) { return {u.x + v.x, u.y + v.y}; }
    static Vector<F> Subtract(const Vector<F>& u, const Vector<F>& v)
    {
        return {u.x - v.x, u.y - v.y};
    }
    static Vector<F> Turn(const F (&body)[4], const Vector<F>& v)
    {
        return {body[3] * v.x - body[2] * v.y, body[2] * v.x + body[3] * v.y};
    }

    template <OverlapKind kKind>
    OverlapLanes<F> Measure(int point) const
    {
        constexpr bool faceOnB = kKind == OverlapKind::FaceB;
        OverlapLanes<F> result;
        const Vector<F> offset = {At(block.offsetX) + b[0] - a[0], At(block.offsetY) + b[1] - a[1]};
        const Vector<F> reference =
            Turn(faceOnB ? b : a, {At(block.referenceX), At(block.referenceY)});
        const Vector<F> other =
            Turn(faceOnB ? a : b, {At(block.pointX[point]), At(block.pointY[point])});
        const F radius = At(block.radius);
        if constexpr (kKind == OverlapKind::Centers)
        {
            MeasureCenters(offset, reference, Add(offset, other), radius, result);
            return result;
        }
        const Vector<F> normal = Turn(faceOnB ? b : a, {At(block.normalX), At(block.normalY)});
        if constexpr (faceOnB)
        {
            const Vector<F> above = Subtract(other, Add(offset, reference));
            result.separation = above.x * normal.x + above.y * normal.y - radius;
            result.armA = other;
            result.armB = Subtract(other, offset);
            result.normal = {-normal.x, -normal.y};
        }
        else
        {
            const Vector<F> above = Subtract(Add(offset, other), reference);
            result.separation = above.x * normal.x + above.y * normal.y - radius;
            result.armA = Add(offset, other);
            result.armB = other;
            result.normal = normal;
        }
        return result;
    }

    void MeasureCenters(const Vector<F>& offset, const Vector<F>& onA, const Vector<F>& onB,
                        F radius, OverlapLanes<F>& result) const
    {
        const F zero = F::Set(0.0f);
        const F one = F::Set(1.0f);
        const F half = F::Set(0.5f);
        const Vector<F> between = Subtract(onB, onA);
        const F length = Sqrt(between.x * between.x + between.y * between.y);
        const auto apart = AtLeast(length, F::Set(kMinLength));
        const F inverse = one / Select(apart, length, one);
        result.normal = {Select(apart, between.x * inverse, one),
                         Select(apart, between.y * inverse, zero)};
        result.separation = Select(apart, length, zero) - radius;
        result.armA = {half * (onA.x + onB.x), half * (onA.y + onB.y)};
        result.armB = Subtract(result.armA, offset);
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
    F PushPoint(PushPace pace)
    {
        const F zero = F::Set(0.0f);
        const OverlapLanes<F> p = Measure<kKind>(0);
        const F out = PushOut(p, pace);
        const auto idle = AtLeast(zero, out);
        const F mass = Mass(p, p);
        const auto massless = AtLeast(zero, mass);
        const F one = F::Set(1.0f);
        const F impulse = out * Select(massless, zero, one / Select(massless, one, mass));
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
        const OverlapLanes<F> p = Measure<kKind>(0);
        const OverlapLanes<F> q = Measure<kKind>(1);
        const F outP = PushOut(p, pace);
        const F outQ = PushOut(q, pace);
        const auto active = Not(And(AtLeast(zero, outP), AtLeast(zero, outQ)));
        nearlyOne = zero;
        if (!Any(active))
        {
            return Min(p.separation, q.separation);
        }
        const F k11 = Mass(p, p);
        const F k12 = Mass(p, q);
        const F k22 = Mass(q, q);
        const F determinant = k11 * k22 - k12 * k12;
        const auto single = AtLeast(k11 * k11, F::Set(kMaxCondition) * determinant);
        nearlyOne = Select(And(active, single), one, zero);
        F x1, x2;
        const auto solved = Enumerate(k11, k12, k22, determinant, -outP, -outQ, x1, x2);
        const auto pushed = And(And(active, Not(single)), solved);
        const F turnA = Cross(p.armA, p.normal) * x1 + Cross(q.armA, q.normal) * x2;
        const F turnB = Cross(p.armB, p.normal) * x1 + Cross(q.armB, q.normal) * x2;
        Move(pushed, p.normal, x1 + x2, -At(masses.invInertiaA) * turnA,
             At(masses.invInertiaB) * turnB);
        return Min(p.separation, q.separation);
    }

    /// See EnumerateImpulses; tries the cases from the last to the first.
    static auto Enumerate(F k11, F k12, F k22, F determinant, F b1, F b2, F& x1, F& x2)
    {
        const F zero = F::Set(0.0f);
        auto solved = And(AtLeast(b1, zero), AtLeast(b2, zero));
        x1 = x2 = zero;
        const F second = -b2 / k22;
        const auto secondOnly = And(AtLeast(second, zero), AtLeast(k12 * second + b1, zero));
        x2 = Select(secondOnly, second, x2);
        const F first = -b1 / k11;
        const auto firstOnly = And(AtLeast(first, zero), AtLeast(k12 * first + b2, zero));
        x1 = Select(firstOnly, first, x1);
        x2 = Select(firstOnly, zero, x2);
        const F inverse = F::Set(1.0f) / determinant;
        const F both1 = inverse * (k12 * b2 - k22 * b1);
        const F both2 = inverse * (k12 * b1 - k11 * b2);
        const auto both = And(AtLeast(both1, zero), AtLeast(both2, zero));
        x1 = Select(both, both1, x1);
        x2 = Select(both, both2, x2);
        return Or(Or(solved, secondOnly), Or(firstOnly, both));
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
                    const float32 found = SolveNearlyOnePoint(
                        block, masses, lane + i, reinterpret_cast<SolverBody*>(bodies), pace);
                    smallest = found < smallest ? found : smallest;
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
        smallest = SmallestOf(solver.template PushPoint<kKind>(pace), smallest);
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
