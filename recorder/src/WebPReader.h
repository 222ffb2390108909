// SPDX-License-Identifier: MIT
#pragma once

#include "VideoSource.h"

#include <filesystem>
#include <memory>

/// Reads the frames of an animated WebP. Used by VideoReader; loads libwebp when called.
namespace boxreel
{

Result<std::unique_ptr<VideoSource>> OpenWebPReader(const std::filesystem::path& path);

} // namespace boxreel
