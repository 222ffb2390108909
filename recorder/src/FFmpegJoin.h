// SPDX-License-Identifier: MIT
#pragma once

#include "VideoFormat.h"

#include <recorder/JoinFilms.h>

/// JoinFilms for formats that libav writes. Loads libav when called.
namespace boxreel
{

Result<JoinedFilm> JoinFFmpegFilms(const std::vector<FilmPart>& parts,
                                   const std::filesystem::path& path, VideoFormat format,
                                   const VideoSettings& settings,
                                   const std::function<bool()>& isStopped);

} // namespace boxreel
