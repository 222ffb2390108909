// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

/// Polygons of the engine and of scene files, each made of the other without a bit lost.
namespace boxreel
{

/// With the corners in the order of the file. Expects what the engine has nothing against.
void SetPolygon(const RubePolygon& polygon, b2PolygonShape& shape);

RubePolygon PolygonOf(const b2PolygonShape& shape);

} // namespace boxreel
