// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

class b2World;

namespace boxreel
{

/// Of shapes that may meet; the first step looks at each and keeps about 300 bytes. A heap of a
/// hundred thousand boxes has half as many.
constexpr std::size_t kMaxPairs = 1'000'000;

/// Whether more pairs of shapes than that have overlapping boxes, at least one of them of a body
/// that can move. Stops when it knows: a few bodies in one place make as many pairs as their
/// square.
bool IsTooCrowded(const b2World& world);

} // namespace boxreel
