// SPDX-License-Identifier: MIT
#pragma once

#include "VideoSink.h"

#include <recorder/VideoWriter.h>

#include <filesystem>
#include <memory>

/// Writes an animated GIF (GIF89a, CompuServe 1990) sequentially. A frame contains only the changed
/// rectangle, only its changed pixels, and only their colours; libav's encoder does not do so after
/// a palette change. Groups of frames are independent: each starts with a full picture and its own
/// palette. Used by VideoWriter.
namespace boxreel
{

/// `settings` must have passed CheckVideoPath.
Result<std::unique_ptr<VideoSink>> OpenGifFilm(const std::filesystem::path& path,
                                               const VideoSettings& settings);

} // namespace boxreel
