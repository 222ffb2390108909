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

/// The two bodies a gear hangs on: one of the first joint and another one of the second, the
/// definition's own when they are that, if possible both dynamic. Null when the joints have no two
/// such bodies.
struct GearBodies
{
    b2Body* a = nullptr;
    b2Body* b = nullptr;
};
GearBodies BodiesOf(const b2GearJointDef& def);

} // namespace box2d
