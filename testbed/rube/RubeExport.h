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

/// What a scene file can say of a scene as it is now: its bodies, shapes, joints, names and the
/// world's settings; of a scene that came from a file, its images and custom properties as well.
/// What the format cannot say is named in `leftOut`.
RubeScene ExportScene(Scene& scene, const StepSettings& steps, float32 stepsPerSecond,
                      RubeNotes& leftOut);

/// The same of a world alone, of bodies and joints that have these names.
RubeScene ExportWorld(b2World& world, const std::map<std::uint32_t, std::string>& bodyNames,
                      const std::map<const b2Joint*, std::string>& jointNames, RubeNotes& leftOut);

} // namespace boxreel
