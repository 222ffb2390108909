// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2BroadPhase.h>

/// @file
/// A summary of the contacts of a world.

class b2Contact;
class b2ContactFilter;
class b2ContactListener;

/// A summary of the contacts of a world, as of the last call of b2World::GetContactManager.
/// Read-only. The broad phase is the live one of the world; the other members are copies.
struct b2ContactManager
{
    b2BroadPhase m_broadPhase;                      ///< the boxes of all fixtures
    b2Contact* m_contactList = nullptr;             ///< newest first
    int32 m_contactCount = 0;                       ///< number of contacts, touching or not
    b2ContactFilter* m_contactFilter = nullptr;     ///< the default filter unless another is set
    b2ContactListener* m_contactListener = nullptr; ///< null: none
};
