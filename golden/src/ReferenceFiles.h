// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The files under a reference store: which names are fit, where a name lies, reading and writing.
/// Knows nothing of what the files mean. Whatever a name or a link in the folder says, nothing
/// outside the folder is read or written.
namespace boxreel
{

/// Empty when `name` is fit for files, otherwise the reason for a person.
std::string WhyNotUsable(const std::string& name);

/// `root` / `relative`, or an Error when a symbolic link on the way leads out of `root` (or
/// nowhere).
Result<std::filesystem::path> PathInside(const std::filesystem::path& root,
                                         const std::filesystem::path& relative);

/// False when nothing is there; an Error when what is there is no file or cannot be looked at.
Result<bool> IsFile(const std::filesystem::path& path);

/// The text that StoredText wrote: FILE.txt, or FILE.txt.gz unpacked; none when there is neither.
/// An Error when there are both, since then it is anybody's guess which one was approved.
Result<std::optional<std::string>> ReadStoredText(const std::filesystem::path& root,
                                                  const std::filesystem::path& relativeTxt);

struct FileToWrite
{
    std::filesystem::path path;
    std::string bytes;
};

/// A text as the store keeps it: plain when short, so that a diff can be read; packed when long.
Result<FileToWrite> StoredText(const std::filesystem::path& pathTxt, std::string text);

/// All are written beside their places first and only then renamed, so that a full disk or a folder
/// without permission leaves every old file as it was. Makes the folders; replaces what is there.
Result<void> WriteAll(const std::vector<FileToWrite>& files);

/// Nothing to remove is fine.
Result<void> RemoveFile(const std::filesystem::path& path);

} // namespace boxreel
