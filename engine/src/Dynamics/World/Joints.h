// SPDX-License-Identifier: MIT
#pragma once

struct b2JointDef;
class b2Joint;

/// Joints of a world: made and destroyed.
namespace box2d
{

class World;

/// Null for a definition that is not sound.
b2Joint* CreateJoint(World& world, const b2JointDef& def);
/// Makes it the newest of the world and its bodies.
void LinkJoint(World& world, b2Joint& joint);
/// With the gears that are made of it.
void DestroyJoint(World& world, b2Joint& joint);
/// Destroys a joint as a consequence of another call, so it calls the destruction listener.
void DestroyJointImplicitly(World& world, b2Joint& joint);

} // namespace box2d
