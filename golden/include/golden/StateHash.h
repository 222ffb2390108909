// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

class b2World;

/// A world's state in 64 bits: every body's position, angle and velocities, bit by bit, in order of
/// creation. Target boxreel::goldenstate; the rest of golden does not know the engine.
namespace boxreel
{

std::uint64_t StateHash(const b2World& world);

/// As 16 lower-case hex digits.
std::string StateHashText(const b2World& world);

} // namespace boxreel
