// SPDX-License-Identifier: MIT
#pragma once

#include "VideoSource.h"

#include <filesystem>
#include <memory>

/// Reads a film with libav. Used by VideoReader; loads libav when called.
namespace boxreel
{

Result<std::unique_ptr<VideoSource>> OpenFFmpegReader(const std::filesystem::path& path);

} // namespace boxreel
