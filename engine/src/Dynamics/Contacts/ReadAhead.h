// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Access.h"

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

/// Loops over contacts know long before their turn which come next. Those that have lived for a
/// while lie anywhere in memory, which has answered by then when it is asked ahead. It changes
/// nothing but time.
namespace box2d
{

inline void Prefetch([[maybe_unused]] const void* memory)
{
#if defined(__GNUC__)
    __builtin_prefetch(memory);
#endif
}

/// Asks for what a step reads of a contact to come, and of the bodies of one that comes sooner.
inline void ReadAhead(const Array<b2Contact*>& contacts, std::size_t present)
{
    constexpr std::size_t ahead = 12;
    if (present + ahead < contacts.size())
    {
        const ContactData& soon = Data(*contacts[present + ahead / 2]);
        const ContactData& later = Data(*contacts[present + ahead]);
        Prefetch(&later.bodyA);
        Prefetch(&later.relative);
        Prefetch(&Data(*soon.bodyA).pose);
        Prefetch(&Data(*soon.bodyB).pose);
    }
}

} // namespace box2d
