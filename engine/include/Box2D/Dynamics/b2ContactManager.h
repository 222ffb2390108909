// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2BroadPhase.h>

/// @file
/// A summary of the contacts of a world.

class b2Contact;
class b2ContactFilter;
class b2ContactListener;

/// What a world says of its contacts in one place, as b2World::GetContactManager found it. To be
/// read: the broad phase is the world's, as it is now, and the rest a copy. Cannot be copied: take
/// a reference.
struct b2ContactManager
{
    b2BroadPhase m_broadPhase;                      ///< the boxes of all fixtures
    b2Contact* m_contactList = nullptr;             ///< newest first
    int32 m_contactCount = 0;                       ///< number of contacts, touching or not
    b2ContactFilter* m_contactFilter = nullptr;     ///< the default filter unless another is set
    b2ContactListener* m_contactListener = nullptr; ///< null: none
};
