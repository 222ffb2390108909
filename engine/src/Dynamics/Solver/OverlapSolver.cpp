// SPDX-License-Identifier: MIT
#include "OverlapSolver.h"
#include "OverlapBlockSolver.h"

namespace box2d
{

Overlap MeasureOverlap(const OverlapBlock& block, int lane, int point, const SolverBody* bodies)
{
    using F = simd::Float1;
    const auto* numbers = reinterpret_cast<const float32*>(bodies);
    F a[4], b[4];
    LoadRows(numbers + 4, kBodyStride, block.bodyA + lane, a);
    LoadRows(numbers + 4, kBodyStride, block.bodyB + lane, b);
    const OverlapLanes<F> o =
        block.kind == OverlapKind::Centers ? Measure<OverlapKind::Centers>(block, lane, point, a, b)
        : block.kind == OverlapKind::FaceA ? Measure<OverlapKind::FaceA>(block, lane, point, a, b)
                                           : Measure<OverlapKind::FaceB>(block, lane, point, a, b);
    return {{o.normal.x.v, o.normal.y.v},
            {o.armA.x.v, o.armA.y.v},
            {o.armB.x.v, o.armB.y.v},
            o.separation.v};
}

void ShortenPush(const SolverBody& before, SolverBody& after, float32 share)
{
    const float32 turn = after.angle - before.angle;
    after.d = before.d + share * (after.d - before.d);
    after.q = before.q;
    after.angle = before.angle;
    if (turn != 0.0f)
    {
        after.Rotate(share * turn);
    }
}

} // namespace box2d
