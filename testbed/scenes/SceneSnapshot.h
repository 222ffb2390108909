// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Scene.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// A scene in the middle, as bytes: its world (b2Snapshot.h) and what it keeps beside it
/// (SceneState.h). A newly created scene that restores it continues bit-exactly as the saved one,
/// so that a part of a film does not need the steps before it.
namespace boxreel
{

std::vector<uint8> SaveScene(Scene& scene);

/// Into a scene of the same kind and settings. Empty when it is done; else one sentence, and the
/// scene is as it was.
std::string RestoreScene(Scene& scene, std::span<const uint8> bytes);

} // namespace boxreel
