// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Files as lines of text, and places in them. Called by the checks of SourceTree.h only.
namespace architecture
{

/// Without line ends; empty when the file cannot be read.
std::vector<std::string> ReadLines(const std::filesystem::path& file);

/// Paths relative to root, with '/', sorted; what a build or git made is left out.
std::vector<std::string> FilesBelow(const std::filesystem::path& root);

/// A header or source of ours, by its name.
bool IsCpp(std::string_view path);

/// Returns the beginning of a finding, "path:line: ", with lines counted from 1.
std::string At(const std::string& path, std::size_t line);

} // namespace architecture
