// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

#include <cstdint>
#include <span>
#include <vector>

class b2World;

/// @file
/// A world as bytes: all that it holds and all that one step leaves to the next, so that a world
/// restored from them goes on as the saved one does, to the last bit and with the same events in
/// the same order, with any number of threads. The bytes are the same on every machine, last as
/// long as the format's version does, and bring a checksum. An addition to the manual's interface.
///
/// Not saved is what belongs to the program rather than to the simulation: listeners, filter, debug
/// drawing, the number of threads, the profile, and what user data points to.

/// What the program makes of its user data: a pointer means nothing in another run, so it says
/// which number to save for it. It is asked about the user data of bodies, fixtures and joints that
/// have some.
class b2SnapshotUserData
{
public:
    virtual ~b2SnapshotUserData() = default;
    /// `userData` is never null.
    virtual std::uint64_t ToNumber(void* userData) = 0;
    /// May be asked by a snapshot that is refused in the end, too.
    virtual void* ToPointer(std::uint64_t number) = 0;
};

/// Between two steps; from inside a callback there is nothing to be saved, and no bytes. Without
/// `userData` what is restored has none. Takes as long as two steps
/// or so.
std::vector<uint8> b2SaveSnapshot(const b2World& world, b2SnapshotUserData* userData = nullptr);

/// Replaces everything that the world holds: bodies with their fixtures, joints, contacts, and the
/// world's settings. Nobody is told that the old ones go, and no pointer or reference that the
/// world gave away is good any more. Listeners, filter, debug drawing and threads stay; a contact
/// filter must decide as the one did under which the snapshot was saved.
///
/// The new bodies are known by b2Body::GetNumber, joints by their place in b2World::GetJointList,
/// both as they were. Bodies that are created later get the numbers that they would have got.
///
/// Null when it is done. Else one sentence, and the world is as it was: bytes that are no snapshot,
/// of another version, cut off or damaged; or a world that is inside a callback.
const char* b2RestoreSnapshot(b2World& world, std::span<const uint8> bytes,
                              b2SnapshotUserData* userData = nullptr);
