// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdio>
#include <string>
#include <string_view>

/// @file
/// What the program writes for people, and how wide and colourful it may be.
namespace boxreel
{

bool IsTerminal(std::FILE* stream);

/// On a terminal, unless NO_COLOR is set to something or TERM is "dumb".
bool UsesColor(std::FILE* stream);

/// Characters in a line of the terminal, 80 when it does not say.
int TerminalColumns(std::FILE* stream);

/// The text in bold or in red where colours are used, as it is elsewhere.
std::string Bold(std::string_view text, std::FILE* stream);
std::string Red(std::string_view text, std::FILE* stream);

/// Standard output, flushed: a full disk behind it is an Error (Failed), not silence.
Result<void> WriteOutput(std::string_view text);

/// Standard error.
void WriteMessage(std::string_view line);

} // namespace boxreel
