// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Parts.h>

/// The assortment of shapes that scenes try things on.
namespace boxreel
{

/// 0 triangle, 1 trapezium, 2 box, 3 octagon, 4 disc.
inline constexpr int32 kSampleKinds = 5;

/// A sample with corners or rim `size` [m] from the body's origin, or a little less.
b2Fixture* AttachSample(b2Body& body, int32 kind, float32 size, const Material& material);

b2Body* AddSample(b2World& world, int32 kind, const b2Vec2& position, float32 angle, float32 size,
                  const Material& material);

} // namespace boxreel
