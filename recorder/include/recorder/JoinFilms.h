// SPDX-License-Identifier: MIT
#pragma once

#include <recorder/VideoWriter.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

/// @file
/// Parts of a film become the whole, without encoding a frame again; of a gif, apng or webp, which
/// lose nothing by it, with. libav is loaded when called.
namespace boxreel
{

/// A film that is part of another.
struct FilmPart
{
    std::filesystem::path path;  ///< of its file
    std::int64_t firstFrame = 0; ///< its number in the whole film
    std::int64_t frames = 0;     ///< how many; 0: as many as it says, or up to the next part
};

/// `parts`: in their order, each beginning where the one before ends, made with the same settings
/// and with groups of frames that end where a part does. Of `settings` count framesPerSecond
/// and overwrite, and of animations groupFrames and plays. An Error (Unusable) when `path` is of a
/// kind that cannot be joined, or the parts are not coded alike. `isStopped`: asked again and
/// again; once it says yes nothing is left, and the answer is false.
Result<bool> JoinFilms(
    const std::vector<FilmPart>& parts, const std::filesystem::path& path,
    const VideoSettings& settings, const std::function<bool()>& isStopped = [] { return false; });

} // namespace boxreel
