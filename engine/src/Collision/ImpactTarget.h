// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// The distance at which continuous collision reports an impact. Searches for impacts and the
/// solution of positions share it, so that resting bodies have no impacts.
namespace box2d
{

/// Overlap of two skins at an impact, and at which position iterations may stop [m]. They approach
/// one slop geometrically, so with one or two resting bodies would have impacts in every step. With
/// four the cores of two polygons, whose skins are four in all, would touch, and closest points
/// would have no direction.
inline constexpr float32 kImpactOverlap = 3.0f * b2_linearSlop;

/// An impact is found up to this distance before the target [m]. It leaves at least 3/4 of a slop
/// between cores. A smaller one needs more steps of the search: with 0.06 slops the search for long
/// bars that rotate together ends before their impact. With 0.6 slops only tests of bits fail.
inline constexpr float32 kImpactTolerance = 0.25f * b2_linearSlop;

/// Returns the distance of two cores at an impact [m], by the sum of their skins. With thin skins,
/// as between two circles' centres, it is still one slop, so that closest points have a direction.
inline float32 ImpactDistance(float32 radii)
{
    return b2Max(b2_linearSlop, radii - kImpactOverlap);
}

} // namespace box2d
