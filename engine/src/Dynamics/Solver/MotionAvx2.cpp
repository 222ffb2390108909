// SPDX-License-Identifier: MIT
// Compiled for AVX2, see ContactBlocksAvx2.cpp.
#include "MotionLanes.h"

namespace box2d
{

int32 MoveRowsAvx2(SolverBody* bodies, int32 count, float32 timeStep, const MaxMove& maximum)
{
    return MoveRows<simd::Float8>(bodies, count, timeStep, maximum);
}

int32 GiveRowsAvx2(SolverBody* bodies, const BodyKick* kicks, int32 count, float32 duration)
{
    return GiveRows<simd::Float8>(bodies, kicks, count, duration);
}

int32 FarthestRowsAvx2(const SolverBody* before, const SolverBody* after, const BodyKick* kicks,
                       int32 count, float32& farthest)
{
    return FarthestRows<simd::Float8>(before, after, kicks, count, farthest);
}

} // namespace box2d
