// SPDX-License-Identifier: MIT
#pragma once

struct b2GearJointDef;
struct b2JointDef;
class b2Body;

/// Checks of a joint's definition before construction. Called by World::CreateJoint only; changes
/// nothing.
namespace box2d
{

/// True for two different bodies and valid numbers. With asserts on, a sentence names the defect.
bool IsSound(const b2JointDef& def);

/// The two different bodies a gear connects, one of each joint: those of the definition. They are
/// replaced only if they are not the joints' bodies, or would leave the gear's bodies in two
/// islands. For example, a post on which a gear wheel rotates does not connect the wheel to
/// anything. Null if the joints have no two different bodies.
struct GearBodies
{
    b2Body* a = nullptr;
    b2Body* b = nullptr;
};
GearBodies BodiesOf(const b2GearJointDef& def);

} // namespace box2d
