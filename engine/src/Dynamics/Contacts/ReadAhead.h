// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Access.h"

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

/// Prefetching for loops over contacts, which know the following elements in advance. Older
/// contacts are scattered in memory. Prefetching affects only time.
namespace box2d
{

inline void Prefetch([[maybe_unused]] const void* memory)
{
#if defined(__GNUC__)
    __builtin_prefetch(memory);
#endif
}

/// Prefetches a later contact, and the bodies of a nearer one.
inline void ReadAhead(const Array<b2Contact*>& contacts, std::size_t present)
{
    constexpr std::size_t ahead = 12;
    if (present + ahead < contacts.size())
    {
        const ContactData& soon = Data(*contacts[present + ahead / 2]);
        const ContactData& later = Data(*contacts[present + ahead]);
        Prefetch(&later.bodyA);
        Prefetch(soon.IsTouching() ? static_cast<const void*>(&soon.manifold) : &soon.proxyA);
        Prefetch(&Data(*soon.bodyA).pose);
        Prefetch(&Data(*soon.bodyB).pose);
    }
}

} // namespace box2d
