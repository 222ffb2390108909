// SPDX-License-Identifier: MIT
#pragma once

#include "Archive.h"

#include "../State/Access.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

/// Bodies, joints and contacts as indices into the lists of a snapshot.
namespace box2d
{

inline int32 PlaceOf(const SnapshotLists&, b2Body& body)
{
    return Data(body).place;
}

inline int32 PlaceOf(const SnapshotLists&, b2Contact& contact)
{
    return Data(contact).place;
}

inline int32 PlaceOf(const SnapshotLists& lists, b2Joint& joint)
{
    const auto found = std::lower_bound(
        lists.joints.begin(), lists.joints.end(), &joint,
        [](b2Joint* a, b2Joint* b) { return JointAccess::Number(*a) < JointAccess::Number(*b); });
    return int32(found - lists.joints.begin());
}

template <class Archive, class Thing>
void VisitReference(Archive& archive, const Array<Thing*>& list, Thing*& thing)
{
    int32 place = 0;
    if constexpr (!Archive::kReads)
    {
        place = PlaceOf(archive.lists, *thing);
    }
    archive(place);
    if constexpr (Archive::kReads)
    {
        archive.Require(place >= 0 && std::size_t(place) < list.size());
        thing = archive.IsSound() ? list[std::size_t(place)] : nullptr;
    }
}

// Null only for invalid archives.

template <class Archive>
void Visit(Archive& archive, b2Body*& body)
{
    VisitReference(archive, archive.lists.bodies, body);
}

template <class Archive>
void Visit(Archive& archive, b2Joint*& joint)
{
    VisitReference(archive, archive.lists.joints, joint);
}

template <class Archive>
void Visit(Archive& archive, b2Contact*& contact)
{
    VisitReference(archive, archive.lists.contacts, contact);
}

/// A list of references; `add(thing, place)` is called for each element read.
template <class Archive, class Thing, class Add>
void VisitList(Archive& archive, Array<Thing*>& list, Add&& add)
{
    auto count = int32(list.size());
    archive.Count(count, sizeof(int32));
    list.resize(std::size_t(count));
    for (int32 i = 0; i < count; ++i)
    {
        archive(list[std::size_t(i)]);
        if (!archive.IsSound())
        {
            list.clear();
            return;
        }
        if constexpr (Archive::kReads)
        {
            add(*list[std::size_t(i)], i);
        }
    }
}

} // namespace box2d
