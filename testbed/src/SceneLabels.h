// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>

/// Names for what is seen, so that a person can say which body is meant.
namespace boxreel
{

/// Adds each body's number (its order of creation), centred on its centre of mass when a metre has
/// that many pixels. The world's debug drawing is borrowed for it and none is registered
/// afterwards.
void AddBodyNumbers(b2World& world, double pixelsPerMeter, DrawList& list);

} // namespace boxreel
