// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

#include <string>
#include <vector>

namespace boxreel
{

/// Builds a scene file's content into a world that is still empty. Called by RubeFile; reads
/// nothing. A fixture or joint that cannot be built is left out, and `leftOut` gets one sentence
/// for it with the names of the part and of its bodies; after a thousand of them one more says how
/// many follow. Returned are the joints in the order of the file, null where one is left out.
std::vector<const b2Joint*> BuildRubeScene(const RubeScene& scene, b2World& world,
                                           std::vector<std::string>& leftOut);

} // namespace boxreel
