// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Internal/BodyData.h>

struct b2BodyDef;
struct b2MassData;
class b2Body;

/// Bodies of a world: made, changed and destroyed. Callers have checked that it is not locked.
namespace box2d
{

class World;

b2Body* CreateBody(World& world, const b2BodyDef& def);
/// An empty one, the newest in the list.
b2Body& AddBody(World& world);
void DestroyBody(World& world, b2Body& body);
void SetTransform(World& world, b2Body& body, const b2Vec2& position, float32 angle);
void SetMassData(BodyData& body, const b2MassData& massData);
/// Discards manifolds, because a shape may have been changed in place.
void ForgetManifolds(BodyData& body);
/// From its fixtures.
void ResetMassData(BodyData& body);
/// After a fixture has been added that weighs nothing. Measures how far its shapes reach from the
/// centre of mass, and how thin they are. Only the newest is looked at: a body of thousands is not
/// measured thousands of times.
void MeasureNewest(BodyData& body);
/// After a shape has changed. Measures all of them.
void MeasureShapes(BodyData& body);
void SetMobility(World& world, b2Body& body, Mobility mobility);
void SetActive(World& world, b2Body& body, bool active);

} // namespace box2d
