// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <render/Backend.h>

#include <filesystem>

namespace boxreel
{

/// Options of `boxreel play`, which checks a script's expectations and makes its files.
struct PlayOptions
{
    std::filesystem::path script;
    std::filesystem::path into; ///< a folder for what is made; empty: the current one
    bool check = false;         ///< only whether it can be played
    bool test = false;          ///< only what it expects and what was approved
    bool accept = false;        ///< pictures become the references that they would be compared with
    bool forThisRenderer = false; ///< and the pictures for the renderer that draws them alone
    bool force = false;
    bool resume = false; ///< films that were stopped are gone on with
    Backend backend = Backend::Auto;
};

/// Declares `boxreel play` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, PlayOptions& options);

/// Checks the options for contradictions; opens nothing.
Result<void> Check(PlayOptions& options);

/// Checks what the script expects, and makes its films and pictures.
Result<int> Run(const PlayOptions& options);

} // namespace boxreel
