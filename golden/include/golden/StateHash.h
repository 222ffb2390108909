// SPDX-License-Identifier: MIT
#pragma once

#include <golden/WorldState.h>

#include <cstdint>
#include <string>

class b2World;

/// @file
/// The only part of golden that knows the engine. A world's state in 64 bits: every body's
/// position, angle and velocities, bit by bit, in order of creation. Target boxreel::goldenstate;
/// the rest of golden does not know the engine.
namespace boxreel
{

/// The state as a number: the same bits have the same, others almost surely another.
std::uint64_t StateHash(const b2World& world);

/// As 16 lower-case hex digits.
std::string StateHashText(const b2World& world);

/// The numbers that are hashed.
WorldState ReadWorldState(const b2World& world);

/// Of `step`, which the world has just done. Called after each step, it makes a StateTrace.
TraceStep ReadTraceStep(const b2World& world, std::int64_t step);

} // namespace boxreel
