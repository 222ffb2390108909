// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <base/Result.h>

#include <string>
#include <vector>

/// Numbers of bodies. The number of a body is its place in the order of creation, also in draw
/// lists and figures.
namespace boxreel
{

/// Returns the number of bodies created so far, which is one more than the number of the newest.
int CountMade(const b2World& world);

/// Checks numbers of bodies named by `option`. Unusable if one is not among the `made` bodies that
/// the scene has had by that moment.
Result<void> CheckBodies(const std::string& option, int made, const std::vector<int>& numbers);

/// The bodies of these numbers, one for each; null where the world has none, or none any more.
std::vector<const b2Body*> FindBodies(const b2World& world, const std::vector<int>& numbers);

} // namespace boxreel
