// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

struct b2AABB;
class b2QueryCallback;
class b2RayCastCallback;

/// Questions to a world, and the move of its origin.
namespace box2d
{

class World;

void Query(const World& world, b2QueryCallback& callback, const b2AABB& box);
void RayCast(const World& world, b2RayCastCallback& callback, const b2Vec2& point1,
             const b2Vec2& point2);
void ShiftOrigin(World& world, const b2Vec2& newOrigin);

} // namespace box2d
