// SPDX-License-Identifier: MIT
#pragma once

#include "Choices.h"

#include <Box2D/Box2D.h>

namespace fuzz
{

/// Creates a joint of any kind between the two bodies; a gear takes two joints of the world.
/// Returns the name of the call.
const char* CreateJoint(b2World& world, b2Body* a, b2Body* b, Choices& choices);

/// Calls a setter of the joint, and the getters that compute something.
const char* ChangeJoint(b2Joint* joint, Choices& choices);

} // namespace fuzz
