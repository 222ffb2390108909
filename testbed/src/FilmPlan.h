// SPDX-License-Identifier: MIT
#pragma once

#include "Commands.h"

/// Which frames a recording makes, and how they are encoded. Opens nothing.
namespace boxreel
{

/// What the options come to before anything is opened.
struct FilmPlan
{
    VideoSettings film;
    std::int64_t frameCount = 0;  ///< of the whole film, or the most when it ends earlier
    FrameRange frames;            ///< those that are made
    std::int64_t groupFrames = 0; ///< from a frame that a part may begin with to the next
};

/// Unusable when the options contradict each other or the format of the output.
Result<FilmPlan> PlanFilm(const RecordOptions& options);

/// A film that may be stopped and continued, or be a part of another, has papers beside it.
bool HasPapers(const RecordOptions& options, const FilmPlan& plan);

} // namespace boxreel
