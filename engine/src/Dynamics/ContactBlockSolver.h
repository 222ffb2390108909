// SPDX-License-Identifier: MIT
#pragma once

#include "ContactBlocks.h"

#include "BodyLanes.h"

/// The contact solver on blocks, for numbers F of 4 or 8 lanes. Line by line what ContactSolver.cpp
/// does to one contact, in the same order of operations. Included by one source for each
/// instruction set; nothing in it has external linkage.
namespace box2d
{
namespace
{

constexpr float32 kNearlyNothing = b2_epsilon; ///< shorter than this has no direction

/// The first four numbers of a body, for each lane.
template <class F>
struct BodyLanes
{
    F row[4]; // vx, vy, w; the angle is along for the ride
};

template <class F>
struct BlockSolver
{
    ContactBlock& block;
    int lane; // the first
    BodyLanes<F> a, b;
    Vector<F> normal;
    bool changed = false; // any impulse, so far
    F invMassA, invInertiaA, invMassB, invInertiaB;

    BlockSolver(ContactBlock& from, int first, const float32* bodies) : block(from), lane(first)
    {
        LoadRows(bodies, kBodyStride, block.bodyA + lane, a.row);
        LoadRows(bodies, kBodyStride, block.bodyB + lane, b.row);
        normal = {At(block.normalX), At(block.normalY)};
        invMassA = At(block.invMassA);
        invInertiaA = At(block.invInertiaA);
        invMassB = At(block.invMassB);
        invInertiaB = At(block.invInertiaB);
    }

    void Store(float32* bodies) const
    {
        StoreMoved(bodies, block.bodyA + lane, uint32(block.movesA) >> lane, a.row);
        StoreMoved(bodies, block.bodyB + lane, uint32(block.movesB) >> lane, b.row);
    }

    F At(const float32* field) const { return F::Load(field + lane); }

    void Note(F before, F after)
    {
        changed = changed || Any(Not(And(AtLeast(before, after), AtLeast(after, before))));
    }

    struct Arms
    {
        Vector<F> a, b;
    };
    Arms ArmsOf(const PointLanes& p) const
    {
        return {{At(p.armAX), At(p.armAY)}, {At(p.armBX), At(p.armBY)}};
    }

    void Apply(const Arms& arms, const Vector<F>& impulse)
    {
        a.row[0] = a.row[0] - invMassA * impulse.x;
        a.row[1] = a.row[1] - invMassA * impulse.y;
        a.row[2] = a.row[2] - invInertiaA * Cross(arms.a, impulse);
        b.row[0] = b.row[0] + invMassB * impulse.x;
        b.row[1] = b.row[1] + invMassB * impulse.y;
        b.row[2] = b.row[2] + invInertiaB * Cross(arms.b, impulse);
    }

    Vector<F> PointSpeed(const Arms& arms) const
    {
        return {b.row[0] - b.row[2] * arms.b.y - a.row[0] + a.row[2] * arms.a.y,
                b.row[1] + b.row[2] * arms.b.x - a.row[1] - a.row[2] * arms.a.x};
    }

    F NormalSpeed(const Arms& arms) const
    {
        const Vector<F> speed = PointSpeed(arms);
        return speed.x * normal.x + speed.y * normal.y;
    }

    void WarmStart(const PointLanes& p)
    {
        const F along = At(p.normalImpulse);
        const F across = At(p.tangentImpulse);
        Apply(ArmsOf(p),
              {along * normal.x + across * normal.y, along * normal.y - across * normal.x});
    }

    void SolveFriction(PointLanes& p)
    {
        const Arms arms = ArmsOf(p);
        const Vector<F> speed = PointSpeed(arms);
        const F slip = speed.x * normal.y - speed.y * normal.x - At(block.tangentSpeed);
        const F limit = At(block.friction) * At(p.normalImpulse);
        const F old = At(p.tangentImpulse);
        const F total = Max(-limit, Min(old - At(p.tangentMass) * slip, limit));
        const F change = total - old;
        Apply(arms, {change * normal.y, -(change * normal.x)});
        Note(old, total);
        total.Store(p.tangentImpulse + lane);
    }

    void SolvePoint(PointLanes& p)
    {
        const Arms arms = ArmsOf(p);
        const F old = At(p.normalImpulse);
        const F wanted = old - At(p.normalMass) * (NormalSpeed(arms) - At(p.bias));
        const F total = Max(wanted, F::Set(0.0f));
        const F change = total - old;
        Apply(arms, {change * normal.x, change * normal.y});
        Note(old, total);
        total.Store(p.normalImpulse + lane);
    }

    /// The four ways of EnumerateImpulses, tried from the last to the first.
    BOX2D_INLINE void SolvePair(PointLanes& p1, PointLanes& p2)
    {
        const F zero = F::Set(0.0f);
        const Arms arms1 = ArmsOf(p1);
        const Arms arms2 = ArmsOf(p2);
        const F k11 = At(block.k11);
        const F k12 = At(block.k12);
        const F k22 = At(block.k22);
        const F old1 = At(p1.normalImpulse);
        const F old2 = At(p2.normalImpulse);
        const F b1 = NormalSpeed(arms1) - At(p1.bias) - (k11 * old1 + k12 * old2);
        const F b2 = NormalSpeed(arms2) - At(p2.bias) - (k12 * old1 + k22 * old2);
        const auto neither = And(AtLeast(b1, zero), AtLeast(b2, zero));
        F x1 = Select(neither, zero, old1);
        F x2 = Select(neither, zero, old2);
        const F second = -b2 / k22;
        const auto secondOnly = And(AtLeast(second, zero), AtLeast(k12 * second + b1, zero));
        x1 = Select(secondOnly, zero, x1);
        x2 = Select(secondOnly, second, x2);
        const F first = -b1 / k11;
        const auto firstOnly = And(AtLeast(first, zero), AtLeast(k12 * first + b2, zero));
        x1 = Select(firstOnly, first, x1);
        x2 = Select(firstOnly, zero, x2);
        const F inverse = F::Set(1.0f) / (k11 * k22 - k12 * k12);
        const F both1 = inverse * (k12 * b2 - k22 * b1);
        const F both2 = inverse * (k12 * b1 - k11 * b2);
        const auto both = And(AtLeast(both1, zero), AtLeast(both2, zero));
        x1 = Select(both, both1, x1);
        x2 = Select(both, both2, x2);
        ApplyPair(arms1, x1 - old1, arms2, x2 - old2);
        Note(old1, x1);
        Note(old2, x2);
        x1.Store(p1.normalImpulse + lane);
        x2.Store(p2.normalImpulse + lane);
    }

    /// Some lanes together, others one point after the other: both ways, then each lane's own.
    BOX2D_NOINLINE void SolveMixed(PointLanes& p1, PointLanes& p2)
    {
        const auto coupled = AtLeast(At(block.coupled), F::Set(1.0f));
        const BodyLanes<F> oldA = a;
        const BodyLanes<F> oldB = b;
        const F old1 = At(p1.normalImpulse);
        const F old2 = At(p2.normalImpulse);
        const bool changedBefore = changed;
        SolvePoint(p1);
        SolvePoint(p2);
        const BodyLanes<F> singleA = a;
        const BodyLanes<F> singleB = b;
        const F single1 = At(p1.normalImpulse);
        const F single2 = At(p2.normalImpulse);
        a = oldA;
        b = oldB;
        old1.Store(p1.normalImpulse + lane);
        old2.Store(p2.normalImpulse + lane);
        SolvePair(p1, p2);
        for (int i = 0; i < 4; ++i)
        {
            a.row[i] = Select(coupled, a.row[i], singleA.row[i]);
            b.row[i] = Select(coupled, b.row[i], singleB.row[i]);
        }
        const F x1 = Select(coupled, At(p1.normalImpulse), single1);
        const F x2 = Select(coupled, At(p2.normalImpulse), single2);
        changed = changedBefore;
        Note(old1, x1);
        Note(old2, x2);
        x1.Store(p1.normalImpulse + lane);
        x2.Store(p2.normalImpulse + lane);
    }

    void ApplyPair(const Arms& arms1, F x1, const Arms& arms2, F x2)
    {
        const F sum = x1 + x2;
        const Vector<F> impulse = {sum * normal.x, sum * normal.y};
        a.row[0] = a.row[0] - invMassA * impulse.x;
        a.row[1] = a.row[1] - invMassA * impulse.y;
        a.row[2] =
            a.row[2] - invInertiaA * (Cross(arms1.a, normal) * x1 + Cross(arms2.a, normal) * x2);
        b.row[0] = b.row[0] + invMassB * impulse.x;
        b.row[1] = b.row[1] + invMassB * impulse.y;
        b.row[2] =
            b.row[2] + invInertiaB * (Cross(arms1.b, normal) * x1 + Cross(arms2.b, normal) * x2);
    }
};

template <class F>
void WarmStartBlock(ContactBlock& block, float32* bodies)
{
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        BlockSolver<F> solver(block, lane, bodies);
        solver.WarmStart(block.points[0]);
        if (block.pointCount == 2)
        {
            solver.WarmStart(block.points[1]);
        }
        solver.Store(bodies);
    }
}

/// False when no impulse changed.
template <class F>
bool SolveBlock(ContactBlock& block, float32* bodies)
{
    bool changed = false;
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        BlockSolver<F> solver(block, lane, bodies);
        PointLanes& p1 = block.points[0];
        PointLanes& p2 = block.points[1];
        solver.SolveFriction(p1);
        if (block.pointCount == 1)
        {
            solver.SolvePoint(p1);
        }
        else
        {
            solver.SolveFriction(p2);
            block.allCoupled ? solver.SolvePair(p1, p2) : solver.SolveMixed(p1, p2);
        }
        solver.Store(bodies);
        changed = changed || solver.changed;
    }
    return changed;
}

} // namespace
} // namespace box2d
