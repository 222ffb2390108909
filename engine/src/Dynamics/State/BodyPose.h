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
b2Vec2 CenterOffset(const BodyData& a, const BodyData& b);
/// Returns body B's frame relative to body A's.
b2Transform RelativeTransform(const BodyData& a, const BodyData& b);

} // namespace box2d
