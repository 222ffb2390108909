// SPDX-License-Identifier: MIT
#pragma once

struct b2GearJointDef;
struct b2JointDef;
class b2Body;

/// What is asked of a joint's definition before the joint is made. Called by World::CreateJoint
/// only; changes nothing.
namespace box2d
{

/// Two different bodies, and numbers a solver can work with. With asserts on, what is missing is
/// said.
bool IsSound(const b2JointDef& def);

/// The two different bodies a gear connects, one of each of its joints: those of the definition.
/// Other ones only where these are none of the joints', or would leave bodies that the gear moves
/// in two islands: a post on which a gear wheel turns does not connect the wheel to anything. Null
/// if the joints have no two different bodies.
struct GearBodies
{
    b2Body* a = nullptr;
    b2Body* b = nullptr;
};
GearBodies BodiesOf(const b2GearJointDef& def);

} // namespace box2d
