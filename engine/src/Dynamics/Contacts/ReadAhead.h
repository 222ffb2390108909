// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Access.h"
#include "../State/World.h"

#include "../../Common/Prefetch.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

/// Prefetching for loops over contacts: older ones are scattered in memory.
namespace box2d
{

/// Prefetches a later contact, and the bodies of a nearer one, unless nothing but their places
/// beside the list is likely to be read.
inline void ReadAhead(const World& world, std::size_t present)
{
    constexpr std::size_t ahead = 24;
    if (present + ahead >= world.awakeContacts.size())
    {
        return;
    }
    const PairLook& later = world.awakeLooks[present + ahead];
    if (later.gap == 0.0f && !later.kept)
    {
        const ContactData& c = Data(*world.awakeContacts[present + ahead]);
        Prefetch(&c.bodyA);
        Prefetch(&c.manifold);
    }
    Prefetch(later.bodyA);
    Prefetch(later.bodyB);
}

} // namespace box2d
