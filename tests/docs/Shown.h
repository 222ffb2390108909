// SPDX-License-Identifier: MIT
#pragma once

#include "../base/ReadBytes.h"

#include <string>

/// True if a page contains a program of docs/examples unchanged, except for the licence in its
/// first line.
inline bool IsShown(const std::string& program, const std::string& page)
{
    const std::string text = ReadBytes(BOXREEL_DOCS "/examples/" + program);
    const std::string shown = "```cpp\n" + text.substr(text.find('\n') + 1) + "```\n";
    return ReadBytes(BOXREEL_DOCS "/" + page).find(shown) != std::string::npos;
}
