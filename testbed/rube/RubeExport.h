// SPDX-License-Identifier: MIT
#pragma once

#include "RubeNames.h"
#include "RubeScene.h"

#include <scenes/Scene.h>

#include <cstdint>
#include <map>
#include <string>

namespace boxreel
{

/// Returns the current state of a scene as a scene file. It contains bodies, shapes, joints, names
/// and the world's settings. If the scene came from a file, it also contains images and custom
/// properties. `leftOut` names the parts that the format cannot express.
RubeScene ExportScene(Scene& scene, const StepSettings& steps, float32 stepsPerSecond,
                      RubeNotes& leftOut);

/// The same of a world alone, of bodies and joints that have these names.
RubeScene ExportWorld(b2World& world, const std::map<std::uint32_t, std::string>& bodyNames,
                      const std::map<const b2Joint*, std::string>& jointNames, RubeNotes& leftOut);

} // namespace boxreel
