// SPDX-License-Identifier: MIT
#pragma once

#include "VideoSink.h"

#include <recorder/VideoWriter.h>

#include <filesystem>
#include <memory>

/// An animated WebP, made by libwebp, which holds all of it in memory (compressed) until the end.
/// Used by VideoWriter; loads libwebp when called.
namespace boxreel
{

/// `settings` must have passed CheckVideoPath. An Error (Absent) when libwebp is missing,
/// (Unusable) for a codec option that it does not know.
Result<std::unique_ptr<VideoSink>> OpenWebPFilm(const std::filesystem::path& path,
                                                const VideoSettings& settings);

} // namespace boxreel
