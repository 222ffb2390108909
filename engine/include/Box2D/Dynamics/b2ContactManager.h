// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2BroadPhase.h>

/// @file
/// A summary of the contacts of a world.

class b2Contact;
class b2ContactFilter;
class b2ContactListener;

/// A read-only summary of the contacts of a world, returned by b2World::GetContactManager. The
/// broad phase is the world's own and is always current. The other members are copies from the time
/// of the call. Cannot be copied; take a reference.
struct b2ContactManager
{
    b2BroadPhase m_broadPhase;                      ///< the boxes of all fixtures
    b2Contact* m_contactList = nullptr;             ///< newest first
    int32 m_contactCount = 0;                       ///< number of contacts, touching or not
    b2ContactFilter* m_contactFilter = nullptr;     ///< the default filter unless another is set
    b2ContactListener* m_contactListener = nullptr; ///< null: none
};
