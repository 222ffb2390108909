// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <filesystem>
#include <string>

/// @file
/// Files, read at once.
namespace boxreel
{

/// The bytes of a regular file. An Error names the path: Unusable when there is no such file, it is
/// not a regular file, is larger than `limit` [bytes] or cannot be opened, Failed when reading it
/// fails.
Result<std::string> ReadWhole(const std::filesystem::path& path, std::uintmax_t limit);

} // namespace boxreel
