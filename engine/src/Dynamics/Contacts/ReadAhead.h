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

/// Prefetches the bodies of a later contact and, unless it is likely to be unchanged, the contact.
/// Up to `end` the calling thread updates; what others write is not asked for.
inline void ReadAhead(const World& world, std::size_t present, std::size_t end)
{
    // Affects the time only. Prefetching every contact as well, 24 or 64 updates ahead, changes no
    // time (docs/notes/collision-speed.md). No note compares other distances for bodies.
    constexpr std::size_t ahead = 24;
    const std::size_t later = present + ahead;
    if (later >= world.awakeContacts.size())
    {
        return;
    }
    const PairLook& look = world.awakeLooks[later];
    if (later >= end || (look.gap == 0.0f && !look.kept))
    {
        const ContactData& c = Data(*world.awakeContacts[later]);
        Prefetch(&c.bodyA);
        Prefetch(&c.manifold);
    }
    Prefetch(look.bodyA);
    Prefetch(look.bodyB);
}

} // namespace box2d
