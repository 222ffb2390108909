// SPDX-License-Identifier: MIT
#pragma once

#include "RubeNames.h"
#include "RubeScene.h"

#include <functional>
#include <vector>

/// The joints of a scene file.
namespace boxreel
{

/// Creates them between `bodies`, which are those of the file, in its order. `leaveOut` is
/// called with each that cannot be built. Returned as they are in the file, null
/// where one is left out.
std::vector<const b2Joint*> BuildRubeJoints(const RubeScene& scene,
                                            const std::vector<b2Body*>& bodies, b2World& world,
                                            const std::function<void(const RubeNote&)>& leaveOut);

} // namespace boxreel
