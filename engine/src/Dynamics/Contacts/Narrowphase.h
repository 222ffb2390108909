// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>
#include <Box2D/Collision/b2Collision.h>

/// From the kinds of two shapes to the function that computes their manifold.
namespace box2d
{

/// Two kinds without a volume have no contact.
bool CanCollide(b2Shape::Type a, b2Shape::Type b);

/// Whether B has to be the contact's first shape, because manifolds are computed for (polygon,
/// circle), (edge, circle), (edge, polygon) only, and chains count as edges.
bool MustSwap(b2Shape::Type a, b2Shape::Type b);

/// The manifold of two children, in an order that MustSwap accepts.
void Collide(b2Manifold* manifold, const b2Shape& a, int32 childA, const b2Shape& b, int32 childB,
             const b2Transform& bInA);

} // namespace box2d
