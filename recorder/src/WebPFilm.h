// SPDX-License-Identifier: MIT
#pragma once

#include "VideoSink.h"

#include <recorder/VideoWriter.h>

#include <filesystem>
#include <memory>

/// Writes an animated WebP with libwebp, which keeps the compressed film in memory until the end.
/// Used by VideoWriter; loads libwebp when called.
namespace boxreel
{

/// `settings` must have passed CheckVideoPath. An Error (Absent) when libwebp is missing,
/// (Unusable) for an unknown codec option.
Result<std::unique_ptr<VideoSink>> OpenWebPFilm(const std::filesystem::path& path,
                                                const VideoSettings& settings);

} // namespace boxreel
