// SPDX-License-Identifier: MIT
#include "OutputPath.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <film/FilmRun.h>
#include <film/StopSignals.h>

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

/// Whether the picture can be written, shows a frame of the film, and is none of its frames.
Result<void> CheckThumbnail(const RecordOptions& options, const FilmPlan& plan)
{
    const auto unusable = [](const std::string& message) {
        return Error{ErrorKind::Unusable, message};
    };
    if (IsFrameOf(options.thumbnail.file, options.output))
    {
        return unusable("--thumbnail " + options.thumbnail.file.string() +
                        " would be a frame of the film itself; choose another name.");
    }
    const std::int64_t count = plan.frames.Count();
    if (options.thumbnail.at && options.length.until.empty() &&
        StepAt(*options.thumbnail.at, plan.film.framesPerSecond) > count)
    {
        return unusable("--thumbnail-at is after the end of what is filmed, " +
                        std::to_string(count) + " frames; give an earlier time.");
    }
    return CheckPicturePath(options.thumbnail.file, options.film.overwrite);
}

/// Asked before anything is simulated.
Result<void> CheckFilm(const RecordOptions& options, const FilmPlan& plan)
{
    RETURN_IF_ERROR(CheckVideoPath(options.output, plan.film));
    RETURN_IF_ERROR(CheckPapersPaths(options, plan));
    return options.thumbnail.file.empty() ? Result<void>() : CheckThumbnail(options, plan);
}

/// Said before the work of a part that nothing can be joined to; pictures need no joining.
void TellLooseParts(const RecordOptions& options, const FilmPlan& plan)
{
    const std::int64_t first = plan.frames.First();
    const bool arePictures = options.output.extension() == ".png";
    if (options.length.range && !arePictures && HasPapers(options, plan) &&
        first % plan.groupFrames != 0)
    {
        WriteMessage("boxreel: Frame " + std::to_string(first) + " is within a group of " +
                     std::to_string(plan.groupFrames) +
                     " frames, so no part can be joined in front of it; begin with a multiple of "
                     "that, or give another --group.");
    }
}

} // namespace

std::vector<std::filesystem::path> FilesOf(const RecordOptions& options)
{
    std::vector<std::filesystem::path> files{options.output};
    if (!options.thumbnail.file.empty())
    {
        files.push_back(options.thumbnail.file);
    }
    return files;
}

Result<void> Prepare(const RecordOptions& options)
{
    ASSIGN_OR_RETURN(const FilmPlan plan, PlanFilm(options));
    const Result<void> usable = CheckFilm(options, plan);
    return usable ? CheckFolderOf(options.output) : usable;
}

Result<int> RunRecord(const RecordOptions& options)
{
    GiveLargeBlocksBack();
    ASSIGN_OR_RETURN(FilmPlan plan, PlanFilm(options));
    if (options.skipDone)
    {
        ASSIGN_OR_RETURN(const bool isDone, IsPartDone(options, plan));
        if (isDone)
        {
            WriteMessage(options.output.string() + " is there already.");
            return 0;
        }
    }
    RETURN_IF_ERROR(CheckFilm(options, plan));
    TellLooseParts(options, plan);
    std::optional<SnapshotFolder> snapshots;
    if (!options.snapshots.folder.empty())
    {
        ASSIGN_OR_RETURN(SnapshotFolder folder,
                         SnapshotFolder::Open(options.snapshots.folder, options.snapshots.every));
        snapshots = std::move(folder);
    }
    ASSIGN_OR_RETURN(SceneSource source, OpenScene(options.scene));
    for (const std::string& line : source.leftOut)
    {
        WriteMessage(line);
    }
    const StopSignals stopSignals;
    return FilmRun(options, std::move(plan), snapshots ? &*snapshots : nullptr)
        .Make(std::move(source));
}

} // namespace boxreel
