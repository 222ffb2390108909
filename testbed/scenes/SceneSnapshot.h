// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Scene.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// A running scene as bytes: its world (b2Snapshot.h) and its own state (SceneState.h). A newly
/// created scene that restores them continues bit-exactly like the saved one, so a part of a film
/// does not need the steps before it.
namespace boxreel
{

std::vector<uint8> SaveScene(Scene& scene);

/// Restores the bytes into a scene of the same kind and settings. Returns an empty text on success,
/// otherwise one sentence, and leaves the scene unchanged.
std::string RestoreScene(Scene& scene, std::span<const uint8> bytes);

} // namespace boxreel
