// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdio>
#include <string>
#include <string_view>

/// @file
/// Output of the program, with the width and colours of the terminal.
namespace boxreel
{

/// True if the stream is shown on a terminal.
bool IsTerminal(std::FILE* stream);

/// True for a terminal, unless NO_COLOR is set and not empty or TERM is "dumb".
bool UsesColor(std::FILE* stream);

/// Returns the number of columns of the terminal; 80 if unknown.
int TerminalColumns(std::FILE* stream);

/// Returns the text in bold where colours are used, otherwise unchanged.
std::string Bold(std::string_view text, std::FILE* stream);
/// Same as above, in red.
std::string Red(std::string_view text, std::FILE* stream);

/// Writes to standard output and flushes. An Error (Failed) when that fails, for example on a full
/// disk.
Result<void> WriteOutput(std::string_view text);

/// Writes to standard error.
void WriteMessage(std::string_view line);

} // namespace boxreel
