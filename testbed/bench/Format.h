// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// What tables are written with.
namespace boxreel
{

/// As printf; a row of a table, no longer than 319 characters.
[[gnu::format(printf, 1, 2)]] std::string Format(const char* format, ...);

} // namespace boxreel
