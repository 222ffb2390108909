// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/b2Snapshot.h>

#include "../Islands/Sleep.h"
#include "BodyState.h"
#include "ContactState.h"
#include "JointState.h"
#include "ListState.h"
#include "SolverState.h"

#include <span>
#include <utility>

namespace box2d
{

namespace
{

/// Increase with every change of the stored data, its order or its meaning. Also when a step uses
/// the data differently, because recordings that depend on a snapshot then change. Joints and
/// settings have a number of their own, so that their changes stay in their files.
constexpr uint32 kVersion = 18 + WorldSettings::kFormat + JointFormats();

/// The bytes before the content. The line ends in `magic` detect a file transferred as text.
struct Header
{
    uint8 magic[8] = {'b', '2', 's', 'n', 'a', 'p', '\r', '\n'};
    uint32 version = kVersion;
    std::uint64_t bytes = 0;    ///< size of the content
    std::uint64_t checksum = 0; ///< checksum of the content

    static constexpr std::size_t kBytes = 28;
};

template <class Archive>
void Visit(Archive& archive, Header& header)
{
    auto& [magic, version, bytes, checksum] = header;
    archive(magic, version, bytes, checksum);
}

/// Each word is mixed in by invertible operations. A change within one word is therefore always
/// detected, and any other almost certainly.
std::uint64_t ChecksumOf(std::span<const uint8> bytes)
{
    constexpr std::uint64_t odd = 0x9E3779B97F4A7C15u; // 2^64 divided by the golden ratio
    const auto mixed = [](std::uint64_t sum, const uint8* from, std::size_t count) {
        uint8 word[sizeof(std::uint64_t)] = {};
        std::memcpy(word, from, count);
        snapshot::Order<std::uint64_t>(word);
        return std::rotl((sum ^ std::bit_cast<std::uint64_t>(word)) * odd, 29);
    };
    std::uint64_t sum = bytes.size();
    const std::size_t whole = bytes.size() / sizeof sum * sizeof sum;
    for (std::size_t i = 0; i < whole; i += sizeof sum)
    {
        sum = mixed(sum, bytes.data() + i, sizeof sum);
    }
    return whole < bytes.size() ? mixed(sum, bytes.data() + whole, bytes.size() - whole) : sum;
}

template <class Archive>
void VisitWorld(Archive& archive, World& world)
{
    // Data of the program is kept: owner, filters, listeners, drawing, profile and threads. Counts
    // follow from the lists, pairs from the contacts; the rest is scratch.
    auto& [owner, settings, allocator, proxies, pairs, graph, islands, awakeBodies, awakeVersion,
           awakeContacts, awakeObstacles, awakeLooks, oldManifolds, attention, solver, subSteps,
           energyGuard, impacts, threads, bodyList, jointList, contactList, bodyCount, jointCount,
           gearCount, inactiveCount, contactCount, bodyNumber, jointNumber, defaultFilter, filter,
           listener, destructionListener, debugDraw, lastSubSteps, inverseStep, stepNumber, profile,
           contactManager, profiling, stepComplete, locked, forcesApplied, hasBullets,
           filtersChanged, directionReversed] = world;
    archive(settings, bodyNumber, jointNumber, inactiveCount);
    archive.Within(lastSubSteps, 1, kMaxSubSteps);
    archive(inverseStep, stepNumber, stepComplete, forcesApplied, hasBullets, filtersChanged,
            directionReversed);
    SnapshotAccess::Visit(archive, proxies);
    VisitBodies(archive, world);
    VisitJoints(archive, world);
    VisitContacts(archive, world);
    SnapshotAccess::Visit(archive, islands);
    VisitAwake(archive, awakeBodies);
    VisitAwake(archive, awakeContacts);
    SnapshotAccess::Visit(archive, graph);
    if (archive.IsSound())
    {
        NoteAwakeContacts(world); // which follow from the contacts
        VisitSolver(archive, world);
    }
}

/// Returns the lists, oldest first, and sets the indices of bodies and contacts.
SnapshotLists ListsOf(World& world)
{
    SnapshotLists lists;
    const auto fill = [](auto& list, auto* newest) {
        for (auto* thing = newest; thing; thing = thing->GetNext())
        {
            list.push_back(thing);
        }
        std::reverse(list.begin(), list.end());
    };
    fill(lists.bodies, world.bodyList);
    fill(lists.joints, world.jointList);
    fill(lists.contacts, world.contactList);
    for (std::size_t i = 0; i < lists.bodies.size(); ++i)
    {
        Data(*lists.bodies[i]).place = int32(i);
    }
    for (std::size_t i = 0; i < lists.contacts.size(); ++i)
    {
        Data(*lists.contacts[i]).place = int32(i);
    }
    return lists;
}

/// Returns null if the bytes match their header.
const char* WhyRefused(std::span<const uint8> bytes)
{
    SnapshotReader reader(bytes);
    Header header;
    reader(header);
    if (!reader.IsSound() || !std::ranges::equal(header.magic, Header().magic))
    {
        return "This is not a snapshot: pass the bytes that b2SaveSnapshot returned.";
    }
    if (header.version != kVersion)
    {
        return "The snapshot is of another version of the engine: save it with this one.";
    }
    if (header.bytes != bytes.size() - Header::kBytes)
    {
        return "The snapshot is not whole: pass all of the bytes that were saved, and no others.";
    }
    return header.checksum == ChecksumOf(bytes.subspan(Header::kBytes))
               ? nullptr
               : "The snapshot is damaged: save it again.";
}

/// Moves the data of the program from one world to the other.
void KeepOwn(World& from, World& to)
{
    to.filter = from.filter == &from.defaultFilter ? &to.defaultFilter : from.filter;
    to.listener = from.listener;
    to.destructionListener = from.destructionListener;
    to.debugDraw = from.debugDraw;
    to.profiling = from.profiling;
    to.threads = std::move(from.threads);
}

} // namespace

} // namespace box2d

std::vector<uint8> b2SaveSnapshot(const b2World& world, b2SnapshotUserData* userData)
{
    if (!B2_REQUIRE(!world.IsLocked(), "b2SaveSnapshot must not be called from inside a callback."))
    {
        return {};
    }
    box2d::World& inner = box2d::SnapshotAccess::Of(world);
    box2d::Header header;
    box2d::SnapshotWriter writer;
    writer.lists = box2d::ListsOf(inner);
    writer.lists.userData = userData;
    writer(header); // overwritten when the content is known
    box2d::VisitWorld(writer, inner);
    std::vector<uint8> bytes = writer.Take();
    header.bytes = bytes.size() - box2d::Header::kBytes;
    header.checksum = box2d::ChecksumOf(std::span(bytes).subspan(box2d::Header::kBytes));
    box2d::SnapshotWriter front;
    front(header);
    std::ranges::copy(front.Take(), bytes.begin());
    return bytes;
}

const char* b2RestoreSnapshot(b2World& world, const uint8* data, std::size_t size,
                              b2SnapshotUserData* userData)
{
    const std::span<const uint8> bytes(data, size);
    if (world.IsLocked())
    {
        return "b2RestoreSnapshot must not be called from inside a callback.";
    }
    if (const char* why = box2d::WhyRefused(bytes))
    {
        return why;
    }
    std::unique_ptr<box2d::World>& old = box2d::SnapshotAccess::Of(world);
    auto restored = std::make_unique<box2d::World>(world, old->settings.gravity, true);
    box2d::SnapshotReader reader(bytes.subspan(box2d::Header::kBytes));
    reader.lists.userData = userData;
    box2d::VisitWorld(reader, *restored);
    if (!reader.IsSound() || !reader.IsAtEnd())
    {
        return "The snapshot contradicts itself: save it again.";
    }
    box2d::KeepOwn(*old, *restored);
    old = std::move(restored);
    return nullptr;
}
