// SPDX-License-Identifier: MIT
#pragma once

#include "Manifest.h"
#include "RecordOptions.h"

/// Selects the frames of a recording and their encoding. Writes nothing.
namespace boxreel
{

/// The effective settings, before anything is opened.
struct FilmPlan
{
    VideoSettings film;
    std::int64_t frameCount = 0;  ///< of the whole film; the maximum if --until may end it
    FrameRange frames;            ///< those that are made
    std::int64_t groupFrames = 0; ///< from a frame that a part may begin with to the next
};

/// Unusable when the options contradict each other.
Result<FilmPlan> PlanFilm(const RecordOptions& options);

/// Returns the difference between this manifest's film and the requested one, as a clause. Empty if
/// both have the same command and the same frames.
std::string DifferenceFromAsked(const Manifest& there, const RecordOptions& options,
                                const FilmPlan& plan);

/// True if the requested part exists and is complete. An Error (Unusable) if the file is another
/// film, or does not match its manifest.
Result<bool> IsPartDone(const RecordOptions& options, const FilmPlan& plan);

/// Error (Unusable) if the path of the manifest holds a foreign file, or the manifest of another
/// film or version, and may not be overwritten.
Result<void> CheckManifestPaths(const RecordOptions& options, const FilmPlan& plan);

/// A film that may be stopped and continued, or be a part of another, has manifest beside it.
bool HasManifest(const RecordOptions& options, const FilmPlan& plan);

} // namespace boxreel
