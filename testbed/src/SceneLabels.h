// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/Result.h>

#include <string>
#include <vector>

/// Which body is meant by a number: its place in the order of creation, as it is in draw lists and
/// figures too.
namespace boxreel
{

/// All bodies, the oldest first.
std::vector<const b2Body*> OldestFirst(const b2World& world);

/// Unusable when the world has no body of one of these numbers, which `option` named.
Result<void> CheckBodies(const std::string& option, const b2World& world,
                         const std::vector<int>& numbers);

/// The bodies of these numbers, one for each; null where the world has none, or none any more.
std::vector<const b2Body*> FindBodies(const b2World& world, const std::vector<int>& numbers);

} // namespace boxreel
