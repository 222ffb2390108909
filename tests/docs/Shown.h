// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/// For tests of the programs that docs/ shows.
inline std::string TextOf(const std::filesystem::path& path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// True if a page contains a program of docs/examples unchanged, except for the licence in its
/// first line.
inline bool IsShown(const std::string& program, const std::string& page)
{
    const std::string text = TextOf(BOXREEL_DOCS "/examples/" + program);
    const std::string shown = "```cpp\n" + text.substr(text.find('\n') + 1) + "```\n";
    return TextOf(BOXREEL_DOCS "/" + page).find(shown) != std::string::npos;
}
