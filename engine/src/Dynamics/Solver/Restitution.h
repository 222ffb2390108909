// SPDX-License-Identifier: MIT
#pragma once

#include "../State/BodyLanes.h"

/// Selects the contacts that bounce, and their speeds. For one contact (simd::Float1) and for
/// numbers F of 4, 8 or 16 lanes, with the same bits. All contact solvers use it. No external
/// linkage, like BodyLanes.h.
namespace box2d
{
namespace
{

/// True if a contact with this normal speed [m/s] bounces. Speeds that approach are negative.
template <class F>
auto IsBouncing(F normalSpeed, const SolverContext& context)
{
    return Less(normalSpeed, F::Set(-context.settings.restitutionThreshold));
}

/// Returns the separation speed that restitution requires [m/s]; 0 if the contact does not bounce.
template <class F>
F BounceSpeed(F normalSpeed, F restitution, const SolverContext& context)
{
    return Select(IsBouncing(normalSpeed, context), -restitution * normalSpeed, F::Set(0.0f));
}

} // namespace
} // namespace box2d
