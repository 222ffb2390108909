// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

#include <cstddef>
#include <cstdint>
#include <vector>
#if __cplusplus > 201703L
#include <span>
#endif

class b2World;

/// @file
/// Saves and restores a world as bytes. A restored world continues with the same bits and the same
/// order of events, with any number of threads. The bytes are the same on every machine, are valid
/// for one version of the format, and contain a checksum. An addition to the manual's interface.
///
/// Data of the program is not saved: listeners, filter, debug drawing, the number of threads, the
/// profile, and the targets of user data.

/// Converts user data to numbers and back, because a pointer is invalid in another run. Called for
/// bodies, fixtures and joints with user data.
class b2SnapshotUserData
{
public:
    virtual ~b2SnapshotUserData() = default;
    /// Returns the number to save. `userData` is never null.
    virtual std::uint64_t ToNumber(void* userData) = 0;
    /// Returns the pointer for a saved number. Also called for snapshots that are rejected later.
    virtual void* ToPointer(std::uint64_t number) = 0;
};

/// Returns the world as bytes. Call it between two steps; inside a callback the result is empty.
/// Without `userData`, restored objects have no user data. Takes about as long as two steps.
std::vector<uint8> b2SaveSnapshot(const b2World& world, b2SnapshotUserData* userData = nullptr);

/// Replaces all bodies, fixtures, joints, contacts and settings of the world. The destruction
/// listener is not called, and all pointers and references into the world become invalid.
/// Listeners, filter, debug drawing and threads remain. A contact filter must decide as the one
/// that was active when the snapshot was saved.
///
/// New bodies keep their b2Body::GetNumber, joints their position in b2World::GetJointList. Later
/// bodies get the same numbers as in the saved world.
///
/// Returns null on success. Otherwise returns a sentence and leaves the world unchanged. This
/// happens if the bytes are not a snapshot, have another version, or are truncated or damaged, or
/// if the world is inside a callback.
const char* b2RestoreSnapshot(b2World& world, const uint8* bytes, std::size_t size,
                              b2SnapshotUserData* userData = nullptr);

#ifdef __cpp_lib_span
/// The same for a span or a vector. For programs in C++20 or later.
inline const char* b2RestoreSnapshot(b2World& world, std::span<const uint8> bytes,
                                     b2SnapshotUserData* userData = nullptr)
{
    return b2RestoreSnapshot(world, bytes.data(), bytes.size(), userData);
}
#endif
