// SPDX-License-Identifier: MIT
#pragma once

struct b2JointDef;

/// What is asked of a joint's definition before the joint is made. Called by World::CreateJoint
/// only; changes nothing.
namespace box2d
{

/// Two different bodies, and numbers a solver can work with. With asserts on, what is missing is
/// said.
bool IsSound(const b2JointDef& def);

} // namespace box2d
