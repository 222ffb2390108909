// SPDX-License-Identifier: MIT
#pragma once

#include "VideoSource.h"

#include <filesystem>
#include <memory>

/// An animated WebP back into frames. Used by VideoReader; loads libwebp when called.
namespace boxreel
{

Result<std::unique_ptr<VideoSource>> OpenWebPReader(const std::filesystem::path& path);

} // namespace boxreel
