// SPDX-License-Identifier: MIT
#pragma once

#include "VideoFormat.h"

#include <recorder/JoinFilms.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

/// Copies frames of a gif, apng or webp by decoding and encoding again, which is lossless. Used to
/// resume and join such films; FFmpegCopy handles the others.
namespace boxreel
{

/// Appends the first `count` frames of the film `from` to `to`, by default all. `settings`: those
/// of `from`. An Error when it cannot be read, or has a different size. Ends early if `isStopped`
/// returns true.
Result<void> CopyAnimation(
    const std::filesystem::path& from, const VideoSettings& settings,
    std::optional<std::int64_t> count, VideoWriter& to,
    const std::function<bool()>& isStopped = [] { return false; });

/// Returns the number of complete frames of an interrupted film: those of all groups but the last.
/// 0 if it is not such a film.
std::int64_t CountWholeAnimation(const std::filesystem::path& left, const VideoSettings& settings);

/// JoinFilms for animations.
Result<JoinedFilm> JoinAnimations(const std::vector<FilmPart>& parts,
                                  const std::filesystem::path& path, const VideoSettings& settings,
                                  const std::function<bool()>& isStopped);

} // namespace boxreel
