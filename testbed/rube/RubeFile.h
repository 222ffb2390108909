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

/// Loads a R.U.B.E. / b2dJson scene file as a scene; its PreferredSteps are those of the file. Used
/// wherever a file is given instead of a scene's name. Parts that cannot be built are omitted and
/// named in `leftOut` (see RubeBuilder.h). A file that is missing, too large, truncated, foreign or
/// malformed is an Error with the file and the place. The limits of RubeJson.h bound memory and
/// time.
Result<std::unique_ptr<Scene>> LoadRubeScene(const std::filesystem::path& file, RubeNotes& leftOut);

/// The same of a text in memory; `source` names it in messages.
Result<std::unique_ptr<Scene>> SceneOfText(std::string_view text, const std::string& source,
                                           RubeNotes& leftOut);

/// RubeTraps of a file.
Result<RubeNotes> TrapsOfFile(const std::filesystem::path& file);

/// Returns the content of the scene's file; null for a scene without a file.
const RubeScene* ContentOfFile(const Scene& scene);

/// Its joints in the order of the file, null where one was left out; of others none. Only to
/// compare: they may have gone.
std::vector<const b2Joint*> JointsOfFile(const Scene& scene);

} // namespace boxreel
