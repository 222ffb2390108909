// SPDX-License-Identifier: MIT
#pragma once

#include "VideoFormat.h"
#include "VideoSink.h"

#include <filesystem>
#include <memory>

/// A film written by libav. Used by VideoWriter; loads libav when called.
namespace boxreel
{

/// `settings` must have passed CheckVideoPath; `format` is written by libav.
Result<std::unique_ptr<VideoSink>> OpenFFmpegFilm(const std::filesystem::path& path,
                                                  VideoFormat format,
                                                  const VideoSettings& settings);

} // namespace boxreel
