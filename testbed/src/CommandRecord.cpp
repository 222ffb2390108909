// SPDX-License-Identifier: MIT
#include "FilmRun.h"
#include "OutputPath.h"
#include "StopSignals.h"
#include "Terminal.h"

#include <malloc.h>

namespace boxreel
{
namespace
{

/// Pictures and the planes of encoders get pages of their own, which go back when they are freed.
/// glibc would soon keep such blocks in its heaps, where one encoder after the other leaves holes
/// behind, and a film's memory would grow with its length.
void GiveLargeBlocksBack()
{
#ifdef M_MMAP_THRESHOLD
    mallopt(M_MMAP_THRESHOLD, 1 << 20); // said once, it no longer adapts itself
#endif
}

} // namespace

Result<int> RunRecord(const RecordOptions& options)
{
    GiveLargeBlocksBack();
    Result<FilmPlan> plan = PlanFilm(options);
    if (!plan)
    {
        return plan.GetError();
    }
    if (options.skipDone)
    {
        const Result<bool> isDone = IsPartDone(options, *plan);
        if (!isDone)
        {
            return isDone.GetError();
        }
        if (*isDone)
        {
            WriteMessage(options.output.string() + " is there already.");
            return 0;
        }
    }
    if (Result<void> usable = CheckVideoPath(options.output, plan->film); !usable)
    {
        return usable.GetError();
    }
    if (Result<void> usable = CheckPapersPaths(options, *plan); !usable)
    {
        return usable.GetError();
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
