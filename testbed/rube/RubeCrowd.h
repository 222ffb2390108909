// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

class b2World;

namespace boxreel
{

/// Maximum number of pairs of shapes that may touch. The first step visits each and stores about
/// 300 bytes. A stack of a hundred thousand boxes has half as many.
constexpr std::size_t kMaxPairs = 1'000'000;

/// True if more than kMaxPairs pairs of shapes have overlapping boxes, at least one of them on a
/// body that can move. Stops counting at the limit, because n bodies in one place make n^2 pairs.
bool IsTooCrowded(const b2World& world);

} // namespace boxreel
