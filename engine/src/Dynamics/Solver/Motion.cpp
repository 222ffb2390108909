// SPDX-License-Identifier: MIT
#include "Motion.h"
#include "MotionLanes.h"
#include "OverlapSolver.h"

#include "../../Common/WideInstructions.h"

namespace box2d
{

#if defined(BOX2D_AVX2)
const MotionKernels& MotionKernelsAvx2(); // MotionAvx2.cpp
#endif

namespace
{

const MotionKernels& Widest()
{
#if defined(BOX2D_AVX2)
    if (LanesInUse() >= 8)
    {
        return MotionKernelsAvx2();
    }
#endif
    return kMotionKernels<simd::Float4>;
}

} // namespace

void MoveByVelocity(SolverBody& body, float32 timeStep, const MaxMove& maximum)
{
    const b2Vec2 path = timeStep * body.v;
    if (path.LengthSquared() > maximum.distance * maximum.distance)
    {
        body.v *= maximum.distance / path.Length();
    }
    const float32 turn = timeStep * body.w;
    if (turn * turn > maximum.turn * maximum.turn)
    {
        body.w *= maximum.turn / b2Abs(turn);
    }
    body.d += timeStep * body.v;
    const float32 delta = timeStep * body.w;
    body.angle += delta;
    body.q = b2Mul(body.q, b2Rot(delta));
}

void MoveByVelocity(SolverBody* bodies, int32 count, float32 timeStep, const MaxMove& maximum)
{
    int32 done = Widest().move(bodies, count, timeStep, maximum);
    done += MoveRows<simd::Float4>(bodies + done, count - done, timeStep, maximum);
    for (; done < count; ++done)
    {
        MoveByVelocity(bodies[done], timeStep, maximum);
    }
}

void GiveKicks(SolverBody* bodies, const BodyKick* kicks, int32 count, float32 duration)
{
    int32 done = Widest().give(bodies, kicks, count, duration);
    done += GiveRows<simd::Float4>(bodies + done, kicks + done, count - done, duration);
    for (; done < count; ++done)
    {
        kicks[done].Give(bodies[done], duration);
    }
}

float32 FarthestPush(const SolverBody* before, const SolverBody* after, const BodyKick* kicks,
                     int32 count)
{
    float32 farthest = 0.0f;
    int32 done = Widest().findFarthest(before, after, kicks, count, farthest);
    done += FarthestRows<simd::Float4>(before + done, after + done, kicks + done, count - done,
                                       farthest);
    for (; done < count; ++done)
    {
        farthest = b2Max(PushOf(before[done], after[done], kicks[done].maxExtent), farthest);
    }
    return farthest;
}

} // namespace box2d
