// SPDX-License-Identifier: MIT
#pragma once

#include "References.h"
#include "SnapshotAccess.h"

#include "../State/ConstraintGraph.h"
#include "../State/Islands.h"

/// The lists that bodies, contacts and joints are in, in their order, which is that in which they
/// are solved and events are reported.
namespace box2d
{

template <class Archive>
void SnapshotAccess::Visit(Archive& archive, Islands& islands)
{
    // `seenIslands` is empty between steps, and `sleepy` is scratch.
    auto& [all, free, seenIslands, sleepy, members, stack, version] = islands;
    constexpr std::size_t minBytes = 2 * sizeof(int32);
    auto count = int32(all.size());
    archive.Count(count, minBytes);
    all.resize(std::size_t(count));
    for (int32 i = 0; i < count && archive.IsSound(); ++i)
    {
        auto& [first, last, size, lostLinks, minSleepTime, maxSleepTime, seen] =
            all[std::size_t(i)];
        archive(lostLinks);
        members.clear();
        for (b2Body* body = first; body != nullptr; body = Data(*body).islandNext)
        {
            members.push_back(body);
        }
        VisitList(archive, members, [&](b2Body& body, int32) {
            archive.Require(Data(body).island == -1);
            if (archive.IsSound())
            {
                islands.Append(i, body);
            }
        });
    }
    archive(free);
    for (const int32 island : free)
    {
        archive.Require(0 <= island && island < count && all[std::size_t(island)].first == nullptr);
        if (!archive.IsSound())
        {
            return;
        }
    }
}

template <class Archive>
void SnapshotAccess::Visit(Archive& archive, ConstraintGraph& graph)
{
    // Forms are looked at again after restoring.
    auto& [contacts, usedColors, contactsChanged, formsChanged, joints, jointVersion, sorted] =
        graph;
    uint32 used = 0;
    for (int32 color = 0; color < ConstraintGraph::kColorCount; ++color)
    {
        archive(contactsChanged[color]);
        VisitList(archive, contacts[color], [&](b2Contact& contact, int32 place) {
            archive.Require(Data(contact).color == -1);
            Data(contact).color = std::int8_t(color);
            Data(contact).colorIndex = place;
        });
        used |= contacts[color].empty() ? 0u : 1u << color;
    }
    VisitList(archive, joints, [&](b2Joint& joint, int32 place) {
        archive.Require(JointAccess::SolverIndex(joint) == -1);
        JointAccess::SolverIndex(joint) = place;
    });
    archive(jointVersion, sorted);
    if constexpr (Archive::kReads)
    {
        usedColors = used;
        graph.NoteAllForms();
    }
}

/// Bodies or contacts, which store their index.
template <class Archive, class Thing>
void VisitAwake(Archive& archive, Array<Thing*>& awake)
{
    VisitList(archive, awake, [&](Thing& thing, int32 place) {
        archive.Require(Data(thing).awakeIndex == -1);
        Data(thing).awakeIndex = place;
    });
}

} // namespace box2d
