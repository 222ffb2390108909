// SPDX-License-Identifier: MIT
#pragma once

#include "FilmPlan.h"

#include <session/SnapshotFolder.h>

/// A recording as a web page: the scene is simulated, and its draw lists are written. Nothing is
/// rendered.
namespace boxreel
{

/// True if the name ends in .html, in either case.
bool IsPage(const std::filesystem::path& path);

/// Unusable for an option that only films have.
Result<void> CheckPage(const RecordOptions& options);

/// Makes the page and returns the exit code. While it runs there is one StopSignals. `snapshots`:
/// where the simulation may begin, and leaves its states; null: nowhere.
Result<int> MakePage(const RecordOptions& options, const FilmPlan& plan, SnapshotFolder* snapshots,
                     SceneSource source);

} // namespace boxreel
