// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Result.h>

#include <string>
#include <vector>

/// Names for what is seen, so that a person can say which body is meant. A body's name is its
/// number in the order of creation, as it is in draw lists and figures too.
namespace boxreel
{

struct NumberedBody
{
    int number = 0;
    const b2Body* body = nullptr;
};

/// All bodies, the oldest first. The world's debug drawing is borrowed for it and none is
/// registered afterwards.
std::vector<NumberedBody> NumberedBodies(b2World& world);

/// Unusable when the world has no body of one of these numbers, which `option` named. Borrows the
/// debug drawing too.
Result<void> CheckBodies(const std::string& option, b2World& world,
                         const std::vector<int>& numbers);

/// The bodies of these numbers, one for each; null where the world has none, or none any more. The
/// world's debug drawing is borrowed for it and none is registered afterwards.
std::vector<const b2Body*> FindBodies(b2World& world, const std::vector<int>& numbers);

/// Adds each body's number, centred on its centre of mass when a metre has
/// that many pixels. The world's debug drawing is borrowed for it and none is registered
/// afterwards.
void AddBodyNumbers(b2World& world, double pixelsPerMeter, DrawList& list);

} // namespace boxreel
