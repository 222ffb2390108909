// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>
#include <Box2D/Collision/b2Collision.h>

/// Selects the manifold function for two shape types.
namespace box2d
{

/// False for two types without an area.
bool CanCollide(b2Shape::Type a, b2Shape::Type b);

/// True if B must be the contact's first shape. Manifolds exist only for (polygon, circle), (edge,
/// circle), (edge, polygon); chains count as edges.
bool MustSwap(b2Shape::Type a, b2Shape::Type b);

/// Computes the manifold of two children, in an order that MustSwap accepts. Returns the gap as
/// described in Manifolds.h.
float32 Collide(b2Manifold* manifold, const b2Shape& a, int32 childA, const b2Shape& b,
                int32 childB, const b2Transform& bInA);

} // namespace box2d
