// SPDX-License-Identifier: MIT
#pragma once

#include <recorder/VideoWriter.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

/// @file
/// Joins the parts of a film without encoding again. Gif, apng and webp are encoded again, which is
/// lossless for them. libav is loaded when called.
namespace boxreel
{

/// A part of a film.
struct FilmPart
{
    std::filesystem::path path;  ///< its file
    std::int64_t firstFrame = 0; ///< number of its first frame in the film
    std::int64_t frames = 0;     ///< number of frames; 0: as stored in the file, or up to the next
                                 ///< part
};

/// What became of a film of parts.
struct JoinedFilm
{
    bool isWhole = false;                 ///< false: it was stopped, and no file is left
    std::optional<std::int64_t> stored{}; ///< frames in the file, where identical ones may be
                                          ///< stored once; none: all
};

/// Joins `parts`, in order and without gaps. They must be made with the same settings and with
/// groups that end with the part. Of `settings` it uses framesPerSecond and overwrite, for
/// animations also groupFrames and plays. Calls `isStopped` repeatedly. If that returns true,
/// JoinFilms ends and leaves no file. An Error (Unusable) when the format of `path` cannot
/// be joined, or the parts have different encodings.
Result<JoinedFilm> JoinFilms(
    const std::vector<FilmPart>& parts, const std::filesystem::path& path,
    const VideoSettings& settings, const std::function<bool()>& isStopped = [] { return false; });

} // namespace boxreel
