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

/// `settings` must have passed CheckVideoPath. Pictures are encoded on threads of their own; each
/// appears whole. Destroyed before Close, the pictures it wrote go.
Result<std::unique_ptr<VideoSink>> OpenPngSequence(const std::filesystem::path& path,
                                                   const VideoSettings& settings);

/// The pictures in the order of their numbers, which must have no gap.
Result<std::unique_ptr<VideoSource>> OpenPngSequenceSource(const std::filesystem::path& path);

} // namespace boxreel
