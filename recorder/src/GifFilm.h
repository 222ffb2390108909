// SPDX-License-Identifier: MIT
#pragma once

#include "VideoSink.h"

#include <recorder/VideoWriter.h>

#include <filesystem>
#include <memory>

/// An animated GIF (GIF89a, CompuServe 1990), written front to back. A frame holds only the
/// rectangle that has changed, in it only the pixels that have, and of the palette only the colours
/// of these; libav's encoder does so no more once the palette has changed. Groups of frames know
/// nothing of each other: each begins with a whole picture and a palette of its own. Used by
/// VideoWriter.
namespace boxreel
{

/// `settings` must have passed CheckVideoPath.
Result<std::unique_ptr<VideoSink>> OpenGifFilm(const std::filesystem::path& path,
                                               const VideoSettings& settings);

} // namespace boxreel
