// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

#include <functional>
#include <string>
#include <vector>

/// The joints of a scene file.
namespace boxreel
{

/// Creates them between `bodies`, which are those of the file, in its order. `report` is told, in a
/// sentence without its full stop, what cannot be built. Returned as they are in the file, null
/// where one is left out.
std::vector<const b2Joint*> BuildRubeJoints(const RubeScene& scene,
                                            const std::vector<b2Body*>& bodies, b2World& world,
                                            const std::function<void(const std::string&)>& report);

} // namespace boxreel
