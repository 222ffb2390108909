// SPDX-License-Identifier: MIT
#pragma once

#include "ContactBlocks.h"

#include "../State/BodyLanes.h"

/// The contact solver on blocks, for numbers F of 1, 4, 8 or 16 lanes. One source per instruction
/// set includes it, so it has no external linkage.
namespace box2d
{
namespace
{

/// So much of the speed that an impulse gives may be rounding. A heavy load of light boxes is not
/// solved again for it. With 1e-4 a stack of 20 sways by 18 mm instead of 0.2; with 0 no test fails
/// (docs/notes/tuned-constants.md).
constexpr float32 kRounding = 8.0f * b2_epsilon;
/// The same of the bodies' own speeds, for a stack on a fast lift: four roundings by half an ulp. A
/// row's speed is a difference, a product and three sums. No note compares other values.
constexpr float32 kSpeedRounding = 2.0f * b2_epsilon;

/// The motion of each contact's bodies along its normal and tangent. Only the difference of the
/// centre velocities matters. The change of each velocity is computed once, from the sums of
/// impulses.
template <class F>
struct MotionLanes
{
    F along, across;
    F wA, wB;
    F push, drag;
};

/// The changes of the normal speeds of two points by a unit impulse at either [1/kg].
template <class F>
struct PairResponse
{
    F k11, k12, k22;

    static PairResponse Of(const ContactBlock& block, int lane)
    {
        const auto at = [lane](const float32* field) { return F::Load(field + lane); };
        const F a1 = at(block.points[0].normalLeverA);
        const F b1 = at(block.points[0].normalLeverB);
        const F a2 = at(block.points[1].normalLeverA);
        const F b2 = at(block.points[1].normalLeverB);
        const F invInertiaA = at(block.masses.invInertiaA);
        const F invInertiaB = at(block.masses.invInertiaB);
        const F mass = at(block.masses.invMassA) + at(block.masses.invMassB);
        return {mass + invInertiaA * a1 * a1 + invInertiaB * b1 * b1,
                mass + invInertiaA * a1 * a2 + invInertiaB * b1 * b2,
                mass + invInertiaA * a2 * a2 + invInertiaB * b2 * b2};
    }

    F Determinant() const { return k11 * k22 - k12 * k12; }

    /// Solves both points together for the speeds b. Of the four cases in which each impulse or its
    /// speed is zero, selects the one with no negative value (total enumeration; Murty, "Linear
    /// Complementarity", 1988). They are tried from the last to the first. False if rounding leaves
    /// none.
    BOX2D_INLINE auto Enumerate(F b1, F b2, F& x1, F& x2) const
    {
        const F zero = F::Set(0.0f);
        const auto neither = And(AtLeast(b1, zero), AtLeast(b2, zero));
        x1 = x2 = zero;
        const F second = -b2 / k22;
        const auto secondOnly = And(AtLeast(second, zero), AtLeast(k12 * second + b1, zero));
        x2 = Select(secondOnly, second, x2);
        const F first = -b1 / k11;
        const auto firstOnly = And(AtLeast(first, zero), AtLeast(k12 * first + b2, zero));
        x1 = Select(firstOnly, first, x1);
        x2 = Select(firstOnly, zero, x2);
        const F inverse = F::Set(1.0f) / Determinant();
        const F both1 = inverse * (k12 * b2 - k22 * b1);
        const F both2 = inverse * (k12 * b1 - k11 * b2);
        const auto both = And(AtLeast(both1, zero), AtLeast(both2, zero));
        x1 = Select(both, both1, x1);
        x2 = Select(both, both2, x2);
        return Or(Or(neither, secondOnly), Or(firstOnly, both));
    }
};

/// True if two points are far enough apart to be solved together.
template <class F>
auto AreCoupled(const ContactBlock& block, int lane)
{
    const auto k = PairResponse<F>::Of(block, lane);
    return Less(k.k11 * k.k11, F::Set(kMaxCondition) * k.Determinant());
}

template <class F>
struct BlockSolver
{
    ContactBlock& block;
    int lane;     // the first
    F a[4], b[4]; // of a body vx, vy, w; the angle is not used
    Vector<F> normal;
    F invMassA, invInertiaA, invMassB, invInertiaB, invMass;
    MotionLanes<F> m;
    F changes = F::Set(0.0f); // maximum change of an impulse so far

    BlockSolver(ContactBlock& from, int first, const float32* bodies) : block(from), lane(first)
    {
        LoadRows(bodies, kBodyStride, block.bodyA + lane, a);
        LoadRows(bodies, kBodyStride, block.bodyB + lane, b);
        normal = {At(block.normalX), At(block.normalY)};
        invMassA = At(block.masses.invMassA);
        invInertiaA = At(block.masses.invInertiaA);
        invMassB = At(block.masses.invMassB);
        invInertiaB = At(block.masses.invInertiaB);
        invMass = invMassA + invMassB;
        const Vector<F> apart = {b[0] - a[0], b[1] - a[1]};
        m.along = apart.x * normal.x + apart.y * normal.y;
        m.across = apart.x * normal.y - apart.y * normal.x;
        m.wA = a[2];
        m.wB = b[2];
        m.push = m.drag = F::Set(0.0f);
    }

    BOX2D_INLINE void Store(float32* bodies)
    {
        const Vector<F> impulse = {m.push * normal.x + m.drag * normal.y,
                                   m.push * normal.y - m.drag * normal.x};
        a[0] = a[0] - invMassA * impulse.x;
        a[1] = a[1] - invMassA * impulse.y;
        a[2] = m.wA;
        b[0] = b[0] + invMassB * impulse.x;
        b[1] = b[1] + invMassB * impulse.y;
        b[2] = m.wB;
        StoreMoved(bodies, block.bodyA + lane, uint32(block.movesA) >> lane, a);
        StoreMoved(bodies, block.bodyB + lane, uint32(block.movesB) >> lane, b);
    }

    F At(const float32* field) const { return F::Load(field + lane); }
    F AtOrZero(bool any, const float32* field) const { return any ? At(field) : F::Set(0.0f); }

    /// True if an impulse changed the speed of its bodies' centres by more than this [m/s].
    bool HasChanged(float32 speed) const { return Any(Less(F::Set(speed), invMass * changes)); }
    void Note(F change) { changes = Max(changes, Abs(change)); }

    void WarmStart(const PointLanes& p)
    {
        const F normalImpulse = At(p.normalImpulse);
        const F tangentImpulse = At(p.tangentImpulse);
        m.wA = m.wA - invInertiaA * (At(p.normalLeverA) * normalImpulse +
                                     At(p.tangentLeverA) * tangentImpulse);
        m.wB = m.wB + invInertiaB * (At(p.normalLeverB) * normalImpulse +
                                     At(p.tangentLeverB) * tangentImpulse);
        m.push = m.push + normalImpulse;
        m.drag = m.drag + tangentImpulse;
    }

    void SolveFriction(int i)
    {
        const PointLanes& p = block.points[i];
        const F slip = m.across + m.wB * At(p.tangentLeverB) - m.wA * At(p.tangentLeverA) -
                       AtOrZero(block.driven, block.tangentSpeed);
        ChangeFriction(i, At(p.tangentImpulse) - At(block.pointMass[i]) * slip);
    }

    /// Sets the tangential impulse, within its limit.
    void ChangeFriction(int i, F wanted)
    {
        PointLanes& p = block.points[i];
        const F leverA = At(p.tangentLeverA);
        const F leverB = At(p.tangentLeverB);
        const F limit = At(block.friction) * At(p.normalImpulse);
        const F total = Max(-limit, Min(wanted, limit));
        const F change = total - At(p.tangentImpulse);
        m.across = m.across + invMass * change;
        m.wA = m.wA - invInertiaA * leverA * change;
        m.wB = m.wB + invInertiaB * leverB * change;
        m.drag = m.drag + change;
        Note(change);
        total.Store(p.tangentImpulse + lane);
    }

    /// Returns the normal speed of a point beyond its target.
    F NormalSpeed(int i) const
    {
        const PointLanes& p = block.points[i];
        return m.along + m.wB * At(p.normalLeverB) - m.wA * At(p.normalLeverA) -
               AtOrZero(block.bounces, block.bias[i]);
    }

    void SolvePoint(int i, F mass)
    {
        PointLanes& p = block.points[i];
        const F old = At(p.normalImpulse);
        const F wanted = old - mass * NormalSpeed(i);
        const F total = Max(wanted, F::Set(0.0f));
        const F change = total - old;
        m.along = m.along + invMass * change;
        m.wA = m.wA - invInertiaA * At(p.normalLeverA) * change;
        m.wB = m.wB + invInertiaB * At(p.normalLeverB) * change;
        m.push = m.push + change;
        Note(change);
        total.Store(p.normalImpulse + lane);
    }

    /// Sets both impulses.
    void ChangePair(F old1, F x1, F old2, F x2)
    {
        PointLanes& p1 = block.points[0];
        PointLanes& p2 = block.points[1];
        const F change1 = x1 - old1;
        const F change2 = x2 - old2;
        m.wA = m.wA - invInertiaA * (At(p1.normalLeverA) * change1 + At(p2.normalLeverA) * change2);
        m.wB = m.wB + invInertiaB * (At(p1.normalLeverB) * change1 + At(p2.normalLeverB) * change2);
        m.push = m.push + (change1 + change2);
        Note(change1);
        Note(change2);
        x1.Store(p1.normalImpulse + lane);
        x2.Store(p2.normalImpulse + lane);
    }

    /// For resting contacts both points push; if that holds in all lanes, the other cases are
    /// skipped.
    BOX2D_INLINE void SolvePair()
    {
        const F zero = F::Set(0.0f);
        const auto response = PairResponse<F>::Of(block, lane);
        const auto [k11, k12, k22] = response;
        const F old1 = At(block.points[0].normalImpulse);
        const F old2 = At(block.points[1].normalImpulse);
        const F b1 = NormalSpeed(0) - (k11 * old1 + k12 * old2);
        const F b2 = NormalSpeed(1) - (k12 * old1 + k22 * old2);
        const F inverse = F::Set(1.0f) / response.Determinant();
        const F both1 = inverse * (k12 * b2 - k22 * b1);
        const F both2 = inverse * (k12 * b1 - k11 * b2);
        const auto both = And(AtLeast(both1, zero), AtLeast(both2, zero));
        if (!Any(Not(both)))
        {
            return ChangePair(old1, both1, old2, both2);
        }
        F x1, x2;
        const auto solved = response.Enumerate(b1, b2, x1, x2);
        ChangePair(old1, Select(solved, x1, old1), old2, Select(solved, x2, old2));
    }

    /// Solves some lanes as pairs and others point by point: computes both and selects per lane.
    void SolveMixed()
    {
        PointLanes& p1 = block.points[0];
        PointLanes& p2 = block.points[1];
        const auto response = PairResponse<F>::Of(block, lane);
        const auto coupled = AreCoupled<F>(block, lane);
        const MotionLanes<F> before = m;
        const F changesBefore = changes;
        const F old1 = At(p1.normalImpulse);
        const F old2 = At(p2.normalImpulse);
        SolvePoint(0, InverseOrZero(response.k11));
        SolvePoint(1, InverseOrZero(response.k22));
        const MotionLanes<F> single = m;
        const F single1 = At(p1.normalImpulse);
        const F single2 = At(p2.normalImpulse);
        m = before;
        old1.Store(p1.normalImpulse + lane);
        old2.Store(p2.normalImpulse + lane);
        SolvePair();
        m.wA = Select(coupled, m.wA, single.wA);
        m.wB = Select(coupled, m.wB, single.wB);
        m.push = Select(coupled, m.push, single.push);
        const F x1 = Select(coupled, At(p1.normalImpulse), single1);
        const F x2 = Select(coupled, At(p2.normalImpulse), single2);
        changes = changesBefore;
        Note(x1 - old1);
        Note(x2 - old2);
        x1.Store(p1.normalImpulse + lane);
        x2.Store(p2.normalImpulse + lane);
    }
};

/// Scales the impulses of a kick for one that is `share` times as long. The change by iterations
/// stops two motions: the approach before the kick, and the part that the kick added. The former
/// does not grow with the kick's length, so the change is passed on unscaled. After the half kick
/// at the start, doubling it would over-relax by 2. Beyond that, iterations diverge, and tall
/// stacks did.
template <class F>
void PassOn(float32* impulse, float32* first, float32 share)
{
    const F ofFirst = F::Set(share > 1.0f ? share - 1.0f : 0.0f);
    const F ofLast = F::Set(share > 1.0f ? 1.0f : share);
    const F scaled = ofLast * F::Load(impulse) + ofFirst * F::Load(first);
    scaled.Store(first);
    scaled.Store(impulse);
}

template <class F>
void AddTo(float32* total, const float32* impulse)
{
    (F::Load(total) + F::Load(impulse)).Store(total);
}

template <class F>
void AddToTotals(const ContactBlock& block, BlockTotals& totals)
{
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        for (int i = 0; i < block.pointCount; ++i)
        {
            AddTo<F>(totals.normal[i] + lane, block.points[i].normalImpulse + lane);
            AddTo<F>(totals.tangent[i] + lane, block.points[i].tangentImpulse + lane);
        }
    }
}

template <class F>
void KickBlock(ContactBlock& block, BlockTotals& totals, float32* bodies, float32 share,
               bool addsLast)
{
    if (addsLast)
    {
        AddToTotals<F>(block, totals);
    }
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        BlockSolver<F> solver(block, lane, bodies);
        for (int i = 0; i < block.pointCount; ++i)
        {
            PointLanes& p = block.points[i];
            PassOn<F>(p.normalImpulse + lane, totals.firstNormal[i] + lane, share);
            PassOn<F>(p.tangentImpulse + lane, totals.firstTangent[i] + lane, share);
            solver.WarmStart(p);
        }
        solver.Store(bodies);
    }
}

template <class F>
void LimitFriction(ContactBlock& block, float32* bodies)
{
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        const auto at = [lane](const float32* field) { return F::Load(field + lane); };
        const auto exceeds = [&](const PointLanes& p) {
            return Any(Less(at(block.friction) * at(p.normalImpulse), Abs(at(p.tangentImpulse))));
        };
        const bool first = exceeds(block.points[0]);
        const bool second = block.pointCount == 2 && exceeds(block.points[1]);
        if (!first && !second)
        {
            continue;
        }
        BlockSolver<F> solver(block, lane, bodies);
        for (int i = 0; i < block.pointCount; ++i)
        {
            solver.ChangeFriction(i, solver.At(block.points[i].tangentImpulse));
        }
        solver.Store(bodies);
    }
}

template <class F>
void FindErrors(const ContactBlock& block, const float32* bodies, const ErrorBounds& bounds,
                float32* off)
{
    const F zero = F::Set(0.0f);
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        const auto at = [lane](const float32* field) { return F::Load(field + lane); };
        F a[4], b[4]; // vx, vy, w
        LoadRows(bodies, kBodyStride, block.bodyA + lane, a);
        LoadRows(bodies, kBodyStride, block.bodyB + lane, b);
        const F x = b[0] - a[0];
        const F y = b[1] - a[1];
        const F along = x * at(block.normalX) + y * at(block.normalY);
        const F across = x * at(block.normalY) - y * at(block.normalX) - at(block.tangentSpeed);
        const F invMass = at(block.masses.invMassA) + at(block.masses.invMassB);
        const F ownSpeed = Abs(a[0]) + Abs(a[1]) + Abs(b[0]) + Abs(b[1]);
        const F maxRounding = F::Set(bounds.rounding);
        F largest = F::Load(off + lane);
        for (int i = 0; i < block.pointCount; ++i)
        {
            const PointLanes& p = block.points[i];
            const F turnA = a[2] * at(p.normalLeverA);
            const F turnB = b[2] * at(p.normalLeverB);
            const F dragA = a[2] * at(p.tangentLeverA);
            const F dragB = b[2] * at(p.tangentLeverB);
            const F speed = along + turnB - turnA;
            const F slip = across + dragB - dragA;
            const F push = at(p.normalImpulse);
            const F limit = F::Set(bounds.sticks) * at(block.friction) * push;
            const F normal = Select(Less(zero, push), Abs(speed), -speed);
            const F tangent = Select(Less(Abs(at(p.tangentImpulse)), limit), Abs(slip), zero);
            const F speeds = ownSpeed + Abs(turnA) + Abs(turnB) + Abs(dragA) + Abs(dragB);
            const F rounding = F::Set(kRounding) * invMass * push + F::Set(kSpeedRounding) * speeds;
            largest = Max(largest, Max(normal, tangent) - Min(rounding, maxRounding));
        }
        largest.Store(off + lane);
    }
}

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

/// Solves lanes of a block with two points, of which some are too close to be solved together.
/// Apart from the others, whose solver then stays in registers.
template <class F>
BOX2D_NOINLINE bool SolveMixedLanes(ContactBlock& block, int lane, float32* bodies,
                                    float32 unchanged)
{
    BlockSolver<F> solver(block, lane, bodies);
    solver.SolveFriction(0);
    solver.SolveFriction(1);
    solver.SolveMixed();
    solver.Store(bodies);
    return solver.HasChanged(unchanged);
}

template <class F>
BOX2D_INLINE bool SolveLanes(ContactBlock& block, int lane, float32* bodies, float32 unchanged)
{
    BlockSolver<F> solver(block, lane, bodies);
    solver.SolveFriction(0);
    if (block.pointCount == 1)
    {
        solver.SolvePoint(0, solver.At(block.pointMass[1]));
    }
    else
    {
        solver.SolveFriction(1);
        solver.SolvePair();
    }
    solver.Store(bodies);
    return solver.HasChanged(unchanged);
}

template <class F>
bool SolveBlock(ContactBlock& block, float32* bodies, float32 unchanged)
{
    const bool mixed = block.pointCount == 2 && !block.allCoupled;
    bool changed = false;
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        const bool some = mixed ? SolveMixedLanes<F>(block, lane, bodies, unchanged)
                                : SolveLanes<F>(block, lane, bodies, unchanged);
        changed = changed || some;
    }
    return changed;
}

} // namespace
} // namespace box2d
