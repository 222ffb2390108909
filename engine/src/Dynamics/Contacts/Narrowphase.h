// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2Shape.h>
#include <Box2D/Collision/b2Collision.h>

/// Selects the manifold function for two shape types.
namespace box2d
{

/// True for a type without an area.
inline bool IsThin(b2Shape::Type type)
{
    return type == b2Shape::e_edge || type == b2Shape::e_chain;
}
/// False for two of these.
bool CanCollide(b2Shape::Type a, b2Shape::Type b);

/// True if B must be the contact's first shape. Manifolds exist only for (polygon, circle), (edge,
/// circle), (edge, polygon); chains count as edges.
bool MustSwap(b2Shape::Type a, b2Shape::Type b);

/// Computes the manifold of a child and a shape without children, in an order that MustSwap
/// accepts. Returns the gap as described in Manifolds.h.
float32 Collide(b2Manifold* manifold, const b2Shape& a, int32 childA, const b2Shape& b,
                const b2Transform& bInA);

} // namespace box2d
