// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Internal/BodyData.h>

/// What is computed of bodies' poses alone: by World whenever it has moved a body, and by the
/// joints.
namespace box2d
{

/// Sine, cosine, transform and single-precision centre from the pose.
void SynchronizePose(BodyData& body);
/// The same when the angle has not changed since.
void SynchronizePlace(BodyData& body);
/// From centre of mass A to centre of mass B [m], exact however far from the origin.
b2Vec2 CenterOffset(const BodyData& a, const BodyData& b);
/// Body B's frame as seen from body A's.
b2Transform RelativeTransform(const BodyData& a, const BodyData& b);

} // namespace box2d
