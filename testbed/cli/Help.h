// SPDX-License-Identifier: MIT
#pragma once

#include "CommandTree.h"

#include <span>
#include <string>

namespace boxreel
{

/// An exit code of the program.
struct ExitCode
{
    const char* code;
    const char* brief;   ///< in a list
    const char* meaning; ///< a sentence
};

/// Returns all exit codes, from the smallest on.
std::span<const ExitCode> ExitCodes();

/// Returns the output of `boxreel COMMAND --help`.
std::string HelpOf(const CommandText& command);

} // namespace boxreel
