// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The files of a reference store: valid names, paths, reading and writing. Independent of their
/// content. No name or link in the folder can cause access outside the folder.
namespace boxreel
{

/// Returns the reason why `name` is invalid for files; empty if it is valid.
std::string WhyNotUsable(const std::string& name);

/// Returns `root` / `relative`, or an Error when a symbolic link on the path leads out of `root` or
/// is broken.
Result<std::filesystem::path> PathInside(const std::filesystem::path& root,
                                         const std::filesystem::path& relative);

/// False if the path does not exist; an Error if it is not a file or not accessible.
Result<bool> IsFile(const std::filesystem::path& path);

/// Reads a text of StoredText: FILE.txt, or FILE.txt.gz decompressed; none if neither exists. An
/// Error if both exist, because the approved one is unknown.
Result<std::optional<std::string>> ReadStoredText(const std::filesystem::path& root,
                                                  const std::filesystem::path& relativeTxt);

struct FileToWrite
{
    std::filesystem::path path;
    std::string bytes;
};

/// Returns a text as it is stored: plain if short, for readable diffs; compressed if long.
Result<FileToWrite> StoredText(const std::filesystem::path& pathTxt, std::string text);

/// Writes all files under temporary names, then renames them. A full disk or missing permission
/// therefore leaves every old file unchanged. Creates the folders; replaces existing files.
Result<void> WriteAll(const std::vector<FileToWrite>& files);

/// Removes a file; it may be missing.
Result<void> RemoveFile(const std::filesystem::path& path);

} // namespace boxreel
