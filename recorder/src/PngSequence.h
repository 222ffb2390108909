// SPDX-License-Identifier: MIT
#pragma once

#include "VideoSink.h"
#include "VideoSource.h"

#include <recorder/VideoWriter.h>

#include <filesystem>
#include <memory>

/// A film as numbered pictures, "frames-####.png". Used by VideoWriter and VideoReader.
namespace boxreel
{

/// `settings` must have passed CheckVideoPath. Separate threads encode the pictures; each appears
/// only when complete. Destruction before Close removes the written pictures.
Result<std::unique_ptr<VideoSink>> OpenPngSequence(const std::filesystem::path& path,
                                                   const VideoSettings& settings);

/// Reads pictures in the order of their numbers, which must have no gap.
Result<std::unique_ptr<VideoSource>> OpenPngSequenceSource(const std::filesystem::path& path);

} // namespace boxreel
