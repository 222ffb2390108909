// SPDX-License-Identifier: MIT
#pragma once

#include <golden/WorldState.h>

#include <cstdint>
#include <string>
#include <vector>

class b2Body;
class b2World;

/// @file
/// A world's state as a 64-bit hash: every body's position, angle and velocities, bit by bit, in
/// creation order. Target boxreel::goldenstate, the only part of golden that depends on the engine.
namespace boxreel
{

/// Returns the hash: equal states have equal hashes, different ones almost certainly not.
std::uint64_t StateHash(const b2World& world);

/// Returns the hash as 16 lower-case hex digits.
std::string StateHashText(const b2World& world);

/// Returns all bodies, the oldest first.
std::vector<const b2Body*> OldestFirst(const b2World& world);

/// Returns the numbers that are hashed.
WorldState ReadWorldState(const b2World& world);

/// Returns the trace of `step`, which the world has just completed. Called after each step, it
/// builds a StateTrace.
TraceStep ReadTraceStep(const b2World& world, std::int64_t step);

} // namespace boxreel
