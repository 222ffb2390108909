// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <rube/RubeNames.h>
#include <scenes/Scene.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Finds the scene that a user typed: a name, regardless of case, spaces and punctuation, or a
/// R.U.B.E. file. Returns a note for each part of a file that cannot be built.
namespace boxreel
{

/// Letters and digits only, lower case: what two spellings of a name have in common.
std::string SceneKey(std::string_view name);

/// A name for files: "Newton's Cradle" becomes "newtons-cradle".
std::string SceneSlug(std::string_view name);

/// The scene of that name, or an Error (Unusable) that suggests the nearest.
Result<const SceneEntry*> FindScene(std::string_view name);

/// Something that can be simulated: a scene of the table or of a file, not created yet.
struct SceneSource
{
    const SceneEntry* entry = nullptr; ///< null: `scene` was loaded from a file
    std::unique_ptr<Scene> scene;
    std::string asked; ///< the argument of OpenScene
    std::string title;
    RubeNotes leftOut; ///< parts of the file that could not be built
};

/// Finds the scene, loads it when it is a file. Names of scenes come first; anything that ends in
/// .json or is an existing file is read as a file.
Result<SceneSource> OpenScene(const std::string& nameOrFile);

} // namespace boxreel
