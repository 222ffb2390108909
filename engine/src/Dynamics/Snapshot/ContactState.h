// SPDX-License-Identifier: MIT
#pragma once

#include "BroadPhaseState.h"
#include "References.h"

#include "../Contacts/Contacts.h"
#include "../State/World.h"

namespace box2d
{

/// The contact's own data. The rest follows from its proxies and lists. The form that it was solved
/// as is found again, and the place of its old manifold means something within an update only.
template <class Archive>
void Visit(Archive& archive, ContactData& contact)
{
    auto& [bodyA, bodyB, flags, gap, relative, friction, restitution, lastShare, radiusA, radiusB,
           toiCount, color, solvedAs, manifold, tangentSpeed, skins, proxyA, proxyB, awakeIndex,
           oldIndex, colorIndex, place, edgeA, edgeB, prev, next] = contact;
    archive(flags, friction, restitution, tangentSpeed, skins, radiusA, radiusB, toiCount);
    archive(manifold, relative, gap, lastShare);
    contact.SetTangentSpeed(tangentSpeed);
}

/// Identified by the proxies whose boxes overlap.
template <class Archive>
void VisitContact(Archive& archive, World& world, b2Contact*& contact)
{
    int32 a = 0;
    int32 b = 0;
    if constexpr (!Archive::kReads)
    {
        const ContactData& c = Data(*contact);
        a = c.proxyA->proxyId;
        b = c.proxyB->proxyId;
    }
    archive(a, b);
    if constexpr (Archive::kReads)
    {
        archive.Require(SnapshotAccess::IsProxy(world.proxies, a) &&
                        SnapshotAccess::IsProxy(world.proxies, b) && !world.pairs.Contains(a, b));
        if (!archive.IsSound())
        {
            return;
        }
        contact = &AddContact(world, *world.proxies.Get(a), *world.proxies.Get(b));
    }
    archive(Data(*contact));
}

template <class Archive>
void VisitContacts(Archive& archive, World& world)
{
    constexpr std::size_t minBytes = 64;
    Array<b2Contact*>& contacts = archive.lists.contacts;
    auto count = int32(contacts.size());
    archive.Count(count, minBytes);
    contacts.resize(std::size_t(count));
    if constexpr (Archive::kReads)
    {
        world.pairs.Reserve(contacts.size());
    }
    for (int32 i = 0; i < count && archive.IsSound(); ++i)
    {
        VisitContact(archive, world, contacts[std::size_t(i)]);
        if (archive.IsSound())
        {
            Data(*contacts[std::size_t(i)]).place = i;
        }
    }
    contacts.resize(archive.IsSound() ? contacts.size() : 0);
}

} // namespace box2d
