// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"

#include <filesystem>

namespace boxreel
{

/// Options of `boxreel check`.
struct CheckOptions
{
    std::filesystem::path file;
};

/// Declares `boxreel check` and its options to the parser, which writes to `options`.
Command& Declare(Command& program, CheckOptions& options);

/// Checks the options for contradictions; opens nothing.
Result<void> Check(CheckOptions& options);

/// Lists what of the scene file cannot be built.
Result<int> Run(const CheckOptions& options);

} // namespace boxreel
