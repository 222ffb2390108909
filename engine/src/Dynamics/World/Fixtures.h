// SPDX-License-Identifier: MIT
#pragma once

struct b2FixtureDef;
class b2BlockAllocator;
class b2Body;
class b2Fixture;
class b2Shape;

/// Fixtures of a body: made, changed and destroyed.
namespace box2d
{

class World;

/// Null for a definition without a sound shape.
b2Fixture* CreateFixture(World& world, b2Body& body, const b2FixtureDef& def);
/// With a copy of the shape, in no tree yet, the newest of its body.
b2Fixture& AddFixture(World& world, b2Body& body, const b2Shape& shape);
void DestroyFixture(World& world, b2Body& body, b2Fixture& fixture);
/// Gives its memory back; it must be out of every list.
void FreeFixture(b2BlockAllocator& allocator, b2Fixture& fixture);
/// Replaces the shape by a copy. False for an unsound shape, or one of another type.
bool SetShape(World& world, b2Fixture& fixture, const b2Shape& shape);
/// After its filter has changed.
void Refilter(World& world, b2Fixture& fixture);
/// After the fixture has become, or ceased to be, a sensor.
void UpdateSensor(World& world, b2Fixture& fixture);

} // namespace box2d
