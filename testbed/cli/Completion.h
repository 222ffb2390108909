// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <optional>

namespace boxreel
{

enum class Shell
{
    Bash,
    Zsh,
};

struct CompletionOptions
{
    std::optional<Shell> shell;
};

/// Declares `boxreel completion` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, CompletionOptions& options);

/// Checks the options for contradictions; opens nothing.
Result<void> Check(CompletionOptions& options);

/// Prints the script.
Result<int> Run(const CompletionOptions& options);

} // namespace boxreel
