// SPDX-License-Identifier: MIT
#pragma once

#include "RubeNames.h"
#include "RubeScene.h"

#include <vector>

namespace boxreel
{

/// Builds a scene file's content into a world that is still empty. Called by RubeFile; reads
/// nothing. A fixture or joint that cannot be built is left out, and named in `leftOut` with its
/// bodies. Returned are the joints in the order of the file, null where one is left out.
std::vector<const b2Joint*> BuildRubeScene(const RubeScene& scene, b2World& world,
                                           RubeNotes& leftOut);

} // namespace boxreel
