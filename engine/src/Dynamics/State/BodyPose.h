// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Internal/BodyData.h>

/// Values derived from bodies' poses. Called by World after each change of a pose, and by joints.
namespace box2d
{

/// Computes sine, cosine, transform and single-precision centre from the pose.
void SynchronizePose(BodyData& body);
/// Same as above, if the angle is unchanged.
void SynchronizePlace(BodyData& body);

/// Returns the vector from centre of mass A to B [m], exact at any distance from the origin.
inline b2Vec2 CenterOffset(const BodyData& a, const BodyData& b)
{
    return b2Vec2(float32(b.pose.x - a.pose.x), float32(b.pose.y - a.pose.y));
}

/// Returns body B's frame relative to body A's.
inline b2Transform RelativeTransform(const BodyData& a, const BodyData& b)
{
    const b2Vec2 originOffset = CenterOffset(a, b) - b2Mul(b.rotation, b.localCenter);
    return b2Transform(b2MulT(a.rotation, originOffset) + a.localCenter,
                       b2MulT(a.rotation, b.rotation));
}

} // namespace box2d
