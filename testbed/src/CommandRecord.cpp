// SPDX-License-Identifier: MIT
#include "FilmRun.h"
#include "OutputPath.h"
#include "StopSignals.h"
#include "Terminal.h"

namespace boxreel
{

Result<int> RunRecord(const RecordOptions& options)
{
    Result<FilmPlan> plan = PlanFilm(options);
    if (!plan)
    {
        return plan.GetError();
    }
    if (!options.thumbnail.empty())
    {
        const Result<void> usable = CheckPicturePath(options.thumbnail, options.film.overwrite);
        if (!usable)
        {
            return usable.GetError();
        }
    }
    std::optional<SnapshotFolder> snapshots;
    if (!options.snapshots.empty())
    {
        Result<SnapshotFolder> folder =
            SnapshotFolder::Open(options.snapshots, options.snapshotEvery);
        if (!folder)
        {
            return folder.GetError();
        }
        snapshots = std::move(*folder);
    }
    Result<SceneSource> source = OpenScene(options.scene);
    if (!source)
    {
        return source.GetError();
    }
    for (const std::string& line : source->leftOut)
    {
        WriteMessage(line);
    }
    const StopSignals stopSignals;
    return FilmRun(options, std::move(*plan), snapshots ? &*snapshots : nullptr)
        .Make(std::move(*source));
}

} // namespace boxreel
