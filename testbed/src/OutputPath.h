// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>

#include <filesystem>

/// Asked before long work is done for a file that could not be written in the end.
namespace boxreel
{

/// Whether a picture can be written there: the name ends in .png, its folder exists and may be
/// written to, and no file is in the way unless `force`. Changes nothing.
Result<void> CheckPicturePath(const std::filesystem::path& path, bool force);

/// The same for a chart, whose name ends in .png or .svg.
Result<void> CheckChartPath(const std::filesystem::path& path, bool force);

} // namespace boxreel
