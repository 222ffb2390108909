// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <filesystem>
#include <string>

/// @file
/// Reads whole files.
namespace boxreel
{

/// Returns the Error (Unusable) for a file that the user named and that does not exist.
Error FileNotFound(const std::filesystem::path& path);

/// Returns the bytes of a regular file. An Error names the path. Unusable: the file does not exist,
/// is not regular, is larger than `limit` [bytes] or cannot be opened. Failed: reading fails.
Result<std::string> ReadWhole(const std::filesystem::path& path, std::uintmax_t limit);

} // namespace boxreel
