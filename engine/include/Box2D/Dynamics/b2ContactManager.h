// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// @file
/// What a world says of its contacts.

class b2Contact;
class b2ContactFilter;
class b2ContactListener;

/// What a world says of its contacts in one place, as b2World::GetContactManager found it. A copy:
/// writing to it changes nothing.
struct b2ContactManager
{
    b2Contact* m_contactList = nullptr;             ///< newest first
    int32 m_contactCount = 0;                       ///< of all contacts, touching or not
    b2ContactFilter* m_contactFilter = nullptr;     ///< the default one unless another is set
    b2ContactListener* m_contactListener = nullptr; ///< null: none
};
