// SPDX-License-Identifier: MIT
#pragma once

#include "Motion.h"

#include "../../Common/TaylorSeries.h"
#include "../State/BodyLanes.h"

/// Kicks and drifts of consecutive bodies, for numbers F of 4 or 8 lanes, with the bits of
/// BodyKick::Give and MoveByVelocity. Included like ContactBlockSolver.h, so it has no external
/// linkage either.
namespace box2d
{

/// The functions at one number of lanes. Each handles as many bodies as fill its lanes and returns
/// their number.
struct MotionKernels
{
    int32 (*move)(SolverBody* bodies, int32 count, float32 timeStep, const MaxMove& maximum);
    int32 (*give)(SolverBody* bodies, const BodyKick* kicks, int32 count, float32 duration);
    int32 (*findFarthest)(const SolverBody* before, const SolverBody* after, const BodyKick* kicks,
                          int32 count, float32& farthest);
};

namespace
{

constexpr int kKickStride = int(sizeof(BodyKick) / sizeof(float32));
static_assert(kKickStride == 8);
constexpr int32 kInARow[] = {0, 1, 2, 3, 4, 5, 6, 7};

/// The bits of SinCos. Angles within a step are small; others are computed one by one.
template <class F>
BOX2D_INLINE void ComputeSinCos(F angle, F& sine, F& cosine)
{
    float32 angles[F::kLanes], sines[F::kLanes], cosines[F::kLanes];
    angle.Store(angles);
    if (Any(Not(AtLeast(F::Set(kSmallAngle), Abs(angle)))))
    {
        for (int i = 0; i < F::kLanes; ++i)
        {
            const SineCosine<float32> of = SinCos(angles[i]);
            sines[i] = of.sine;
            cosines[i] = of.cosine;
        }
    }
    else
    {
        for (int i = 0; i < F::kLanes; ++i)
        {
            sines[i] = float32(TaylorSine<kTermsOfSmall>(double(angles[i])));
            cosines[i] = float32(TaylorCosine<kTermsOfSmall>(double(angles[i])));
        }
    }
    const F zero = F::Set(0.0f);
    sine = Select(And(AtLeast(angle, zero), AtLeast(zero, angle)), angle, F::Load(sines));
    cosine = F::Load(cosines);
}

/// Clamps as Bounded does.
template <class F>
F BoundedLanes(F speed)
{
    const F fastest = F::Set(kFastest);
    return Select(AtLeast(speed, speed), Clamp(speed, -fastest, fastest), F::Set(0.0f));
}

template <class F>
void MoveLanes(float32* bodies, F h, const MaxMove& maximum)
{
    F v[4]; // vx, vy, w, angle
    F d[4]; // dx, dy, sine, cosine
    LoadRows(bodies, kBodyStride, kInARow, v);
    LoadRows(bodies + 4, kBodyStride, kInARow, d);
    const Vector<F> path = {h * v[0], h * v[1]};
    const F length2 = path.x * path.x + path.y * path.y;
    const auto isFar = Less(F::Set(maximum.distance * maximum.distance), length2);
    if (Any(isFar))
    {
        const F factor = F::Set(maximum.distance) / Sqrt(length2);
        v[0] = Select(isFar, v[0] * factor, v[0]);
        v[1] = Select(isFar, v[1] * factor, v[1]);
    }
    const F turn = h * v[2];
    const auto turnsFar = Less(F::Set(maximum.turn * maximum.turn), turn * turn);
    if (Any(turnsFar))
    {
        v[2] = Select(turnsFar, v[2] * (F::Set(maximum.turn) / Abs(turn)), v[2]);
    }
    d[0] = d[0] + h * v[0];
    d[1] = d[1] + h * v[1];
    const F delta = h * v[2];
    v[3] = v[3] + delta;
    F sine, cosine;
    ComputeSinCos(delta, sine, cosine);
    const F s = d[2] * cosine + d[3] * sine;
    const F c = d[3] * cosine - d[2] * sine;
    d[2] = s;
    d[3] = c;
    StoreRows(bodies, kBodyStride, kInARow, v);
    StoreRows(bodies + 4, kBodyStride, kInARow, d);
}

template <class F>
int32 MoveRows(SolverBody* bodies, int32 count, float32 timeStep, const MaxMove& maximum)
{
    int32 i = 0;
    for (; i + F::kLanes <= count; i += F::kLanes)
    {
        MoveLanes(reinterpret_cast<float32*>(bodies + i), F::Set(timeStep), maximum);
    }
    return i;
}

/// The factor and the effective time of Decay.
template <class F>
BOX2D_INLINE void ComputeDecay(F t, F damping, F& left, F& time)
{
    const F one = F::Set(1.0f);
    const F half = F::Set(0.5f);
    const F z = damping * t;
    const auto damped = Less(F::Set(0.0f), damping);
    left = Select(damped, one / (one + z + half * z * z), one);
    time = Select(damped, t * (one + half * z) * left, t);
}

template <class F>
int32 GiveRows(SolverBody* bodies, const BodyKick* kicks, int32 count, float32 duration)
{
    const F t = F::Set(duration);
    int32 i = 0;
    for (; i + F::kLanes <= count; i += F::kLanes)
    {
        float32* const body = reinterpret_cast<float32*>(bodies + i);
        const float32* const kick = reinterpret_cast<const float32*>(kicks + i);
        F v[4]; // vx, vy, w, angle
        F a[4]; // ax, ay, angular acceleration, linear damping
        F c[4]; // ay, angular acceleration, linear damping, angular damping
        LoadRows(body, kBodyStride, kInARow, v);
        LoadRows(kick, kKickStride, kInARow, a);
        LoadRows(kick + 1, kKickStride, kInARow, c);
        F left, time;
        ComputeDecay(t, a[3], left, time);
        v[0] = BoundedLanes(left * v[0] + time * a[0]);
        v[1] = BoundedLanes(left * v[1] + time * a[1]);
        ComputeDecay(t, c[3], left, time);
        v[2] = BoundedLanes(left * v[2] + time * a[2]);
        StoreRows(body, kBodyStride, kInARow, v);
    }
    return i;
}

template <class F>
int32 FarthestRows(const SolverBody* before, const SolverBody* after, const BodyKick* kicks,
                   int32 count, float32& farthest)
{
    F maximum = F::Set(farthest);
    int32 i = 0;
    for (; i + F::kLanes <= count; i += F::kLanes)
    {
        const auto* const from = reinterpret_cast<const float32*>(before + i);
        const auto* const to = reinterpret_cast<const float32*>(after + i);
        F v[4], p[4], d[4], e[4]; // the last of v and p are angles, the first two of d and e places
        F k[4];                   // the last are extents
        LoadRows(from, kBodyStride, kInARow, v);
        LoadRows(to, kBodyStride, kInARow, p);
        LoadRows(from + 4, kBodyStride, kInARow, d);
        LoadRows(to + 4, kBodyStride, kInARow, e);
        LoadRows(reinterpret_cast<const float32*>(kicks + i) + 4, kKickStride, kInARow, k);
        const F path = Length<F>({e[0] - d[0], e[1] - d[1]}) + Abs(p[3] - v[3]) * k[3];
        maximum = Max(path, maximum);
    }
    float32 lanes[F::kLanes];
    maximum.Store(lanes);
    for (const float32 lane : lanes)
    {
        farthest = lane > farthest ? lane : farthest;
    }
    return i;
}

template <class F>
constexpr MotionKernels kMotionKernels = {MoveRows<F>, GiveRows<F>, FarthestRows<F>};

} // namespace
} // namespace box2d
