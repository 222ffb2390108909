// SPDX-License-Identifier: MIT
#pragma once

#include "VideoFormat.h"

#include <recorder/JoinFilms.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

/// Frames of one gif, apng or webp into another: read back, as they come back unchanged, and
/// written once more. Used to continue and to join such films; for others there is FFmpegCopy.
namespace boxreel
{

/// Appends the first `count` frames of the film `from` to `to`, all that are there unless said.
/// `settings`: those that `from` was made with. An Error when it cannot be read so far, or has
/// another size. Ends early once `isStopped` says so.
Result<void> CopyAnimation(
    const std::filesystem::path& from, const VideoSettings& settings,
    std::optional<std::int64_t> count, VideoWriter& to,
    const std::function<bool()>& isStopped = [] { return false; });

/// How many frames of an interrupted film are whole: those of the groups that another one follows.
/// None when it is no such film.
std::int64_t CountWholeAnimation(const std::filesystem::path& left, const VideoSettings& settings);

/// JoinFilms for animations.
Result<bool> JoinAnimations(const std::vector<FilmPart>& parts, const std::filesystem::path& path,
                            const VideoSettings& settings, const std::function<bool()>& isStopped);

} // namespace boxreel
