// SPDX-License-Identifier: MIT
#pragma once

#include "RubeNames.h"

#include <base/Result.h>
#include <scenes/Scene.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace boxreel
{

struct RubeScene;

/// Loads a R.U.B.E. / b2dJson scene file as a scene whose PreferredSteps are the file's. Called by
/// whoever is given a file instead of a scene's name. What cannot be built is left out
/// and named in `leftOut` (see RubeBuilder.h). A file that is missing, too large,
/// truncated, foreign or malformed is an Error that names it and the place; memory and time are
/// bounded by the limits of RubeJson.h.
Result<std::unique_ptr<Scene>> LoadRubeScene(const std::filesystem::path& file, RubeNotes& leftOut);

/// The same of a text in memory; `source` names it in messages.
Result<std::unique_ptr<Scene>> SceneOfText(std::string_view text, const std::string& source,
                                           RubeNotes& leftOut);

/// RubeTraps of a file.
Result<RubeNotes> TrapsOfFile(const std::filesystem::path& file);

/// What the file said of a scene that came from one; null of others.
const RubeScene* ContentOfFile(const Scene& scene);

/// Its joints in the order of the file, null where one was left out; of others none. Only to
/// compare: they may have gone.
std::vector<const b2Joint*> JointsOfFile(const Scene& scene);

} // namespace boxreel
